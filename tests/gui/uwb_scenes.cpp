// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/uwb_scenes.h"

#include "gui/scenes.h"

namespace agv::scenes {
namespace {

UwbTagSnapshot locatedTag()
{
    UwbTagSnapshot tag;
    tag.id = 0;
    tag.label = "T0";
    tag.agv = RobotId{1};
    tag.position = Point2{1.204, 0.873};
    tag.covariance = {4e-4, 1e-5, 6e-4};
    tag.z_m = 0.3;
    tag.reportsPerSecond = 10.0;
    tag.age_s = 0.1;
    tag.ranges = {{0, 2.318, 0.012, false},
                  {1, 2.604, -0.021, false},
                  {2, 4.441, 0.304, true},
                  {3, 3.957, 0.018, false}};
    tag.r95_m = 0.043;
    tag.reports = 1834;
    tag.missed = 12;
    return tag;
}

UwbTagSnapshot strangeTag()
{
    UwbTagSnapshot tag;
    tag.id = 5;
    tag.reason = "Only 2 of the 3 ranges that a position needs: look for what hides the anchors";
    tag.reportsPerSecond = 9.8;
    tag.age_s = 0.2;
    tag.ranges = {{0, 3.871, {}, false}, {3, 1.204, {}, false}};
    tag.reports = 96;
    return tag;
}

} // namespace

PlantLayout uwbPlant()
{
    PlantLayout plant = wholePlant();
    plant.anchors = {{0, "A0", -0.15, -0.15, 2.1, true},
                     {1, "A1", 3.15, -0.15, 2.1, true},
                     {2, "A2", 3.15, 4.15, 2.1, true},
                     {3, "A3", -0.15, 4.15, 2.1, true}};
    plant.uwb.port.path = "/dev/ttyACM0";
    UwbTag tag;
    tag.id = 0;
    tag.label = "T0";
    tag.agv = RobotId{1};
    tag.z_m = 0.3;
    tag.mount = {0.05, 0.0};
    plant.uwb.tags = {tag};
    plant.uwb.corrections = {{1, 0, -0.052}};
    return plant;
}

PlantSnapshot uwbRunning()
{
    PlantSnapshot snapshot = finished();
    UwbSnapshot uwb;
    uwb.link.name = "UWB unit";
    uwb.link.address = "/dev/ttyACM0";
    uwb.link.state = LinkState::Up;
    uwb.link.messagesPerSecond = 20.0;
    uwb.link.dataAge_s = 0.1;
    uwb.dialect = UwbDialect::Trek;
    uwb.unit = UwbUnit{"Ver.2.25mx TREK", {true, 2, UwbRole::Anchor, 0}};
    uwb.tags = {locatedTag(), strangeTag()};
    for (int id = 0; id < 4; ++id)
        uwb.anchors.push_back({id, 19.6, 0.1, ResidualSummary{0.006 * id - 0.01, 0.024, 200}, {}});
    uwb.anchors[2].residual = ResidualSummary{0.304, 0.031, 200};
    uwb.anchors[2].warning =
        "Ranges fit a place 320 mm from the one in the list: measure the anchor again or restore it";
    snapshot.uwb = uwb;
    return snapshot;
}

PlantSnapshot uwbCalibrating(RangeCalibrationState state, double progress)
{
    PlantSnapshot snapshot = uwbRunning();
    RangeCalibrationSnapshot& calibration = snapshot.uwb->calibration;
    calibration.state = state;
    calibration.tag = 0;
    calibration.progress = progress;
    const int count = static_cast<int>(300 * progress);
    if (state == RangeCalibrationState::Failed) {
        calibration.reason = "The tag was not heard: switch it on";
        return snapshot;
    }
    calibration.rows = {
        {0, count, -0.031, 0.022}, {1, count, -0.048, 0.019}, {2, count, -0.027, 0.024}, {3, 4, {}, 0.0}};
    return snapshot;
}

AnchorSurvey uwbSurvey()
{
    AnchorSurvey survey;
    survey.anchors = {
        {0, {0.0, 0.0}, 0.012}, {1, {3.3, 0.0}, 0.012}, {2, {3.3, 3.98}, 0.015}, {3, {0.0, 4.3}, 0.014}};
    survey.residual_m = 0.021;
    return survey;
}

} // namespace agv::scenes
