// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <span>

namespace agv::estimation {

/// Where the antenna stood at one stop, as a complex number x + iy, m.
struct AntennaFix {
    std::complex<double> position;
    double weight = 0.0; ///< 1 / variance per axis, 1/m^2; 0: no fix
};

struct CirclePrior {
    double radius_m = 0.1;
    double radiusSd_m = 0.002;
    double step = 0.0; ///< rad, signed: positive counter-clockwise
    double stepSd = 0.0;
    double scanHalf = 0.0; ///< rad: steps within +- this of `step` are tried
};

struct CircleFit {
    bool valid = false;
    std::complex<double> centre; ///< m
    std::complex<double> arm;    ///< centre to antenna at stop 0, m
    double step = 0.0;           ///< rad, signed
    double cost = 0.0;           ///< minus twice the log density, up to a constant
    double centreSd_m = 0.0;     ///< per axis
    double bearingSd = 0.0;      ///< rad, of arg(arm)
    double stepSd = 0.0;         ///< rad
};

/// Weighted least squares of z_k = c + u exp(i k s): linear in the complex centre c and arm u for a given
/// step s, which is scanned. |u| is drawn to the known radius. (Study, `fast`; the linear circle fit in
/// complex form.) Needs two fixes.
CircleFit fitCircle(std::span<const AntennaFix> fixes, const CirclePrior& prior);

} // namespace agv::estimation
