// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/anchor_survey.h"
#include "core/plant_layout.h"
#include "core/snapshot.h"

/// A plant with a UWB kit, for tests and pictures of the window.
namespace agv::scenes {

/// wholePlant() with anchors A0 to A3 in its corners, tag T0 on AGV 1 and one correction (A1, T0: -52 mm).
PlantLayout uwbPlant();

/// A0 to A3 range T0, which has a fix, and T5, which is not listed and has none; A2 is held for moved, and
/// one range of T0 is rejected.
PlantSnapshot uwbRunning();

/// The same, with a calibration of T0 in this state.
PlantSnapshot uwbCalibrating(RangeCalibrationState state, double progress);

/// The anchors of uwbPlant(), A2 elsewhere by 320 mm.
AnchorSurvey uwbSurvey();

} // namespace agv::scenes
