// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/uwb_files.h"
#include "core/result.h"
#include "estimation/uwb/bias_calibration.h"

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace agv::app {

/// Errors of the ranges, learnt from a file of ranges taken at known places.
class UwbCalibration {
public:
    /// `files`: "RANGES:TRUTH". `height_m`: of the tags where the truth does not say. What is wrong with
    /// single lines is named on `err`. Errors name file and line.
    static Result<UwbCalibration> read(const std::string& files, const AnchorSet& anchors, double height_m,
                                       std::ostream& err);

    /// The errors for ranges of `group` in the file `path`. When that is the file of the calibration itself,
    /// its ranges of the same group are left out, so that no place is judged by itself; NoSolution when
    /// nothing is left.
    Result<estimation::RangeBiases> biasesFor(const std::string& path, const std::string& group) const;

    /// Is this the file that was learnt from, and has it no groups that could be left out?
    bool judgesItself(const std::string& path) const;

private:
    struct Sample {
        int tag = 0;
        int anchor = 0;
        int place = 0;
        double range_m = 0.0;
        double distance_m = 0.0;
    };

    Result<estimation::RangeBiases> solveWithout(const std::string* group) const;

    std::string m_rangesPath;
    std::map<std::string, std::vector<Sample>> m_samples; ///< by group
};

} // namespace agv::app
