// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "core/plant_layout.h"
#include "core/uwb_snapshot.h"

#include <QLocale>

/// A small UWB kit for tests of its tables.
namespace agv::kit {

using Tester = QAbstractItemModelTester;

inline std::vector<UwbAnchor> threeAnchors()
{
    return {{0, "A0", 0.0, 0.0, 2.0, true}, {1, "A1", 3.0, 0.0, 2.0, true}, {7, "", 0.0, 4.0, 2.0, false}};
}

inline UwbSettings oneTag()
{
    UwbSettings settings;
    UwbTag tag;
    tag.id = 3;
    tag.label = "Lift";
    tag.z_m = 0.45;
    settings.tags = {tag};
    settings.corrections = {{1, 3, -0.052}};
    return settings;
}

inline UwbSnapshot heard()
{
    UwbSnapshot uwb;
    uwb.anchors = {{0, 9.9, 0.1, ResidualSummary{0.0124, 0.031, 200}, {}},
                   {1, 0.0, {}, {}, {}},
                   {7, 5.0, 0.2, ResidualSummary{-0.3, 0.05, 80}, "Ranges do not fit"}};
    UwbTagSnapshot fix;
    fix.id = 3;
    fix.position = Point2{1.2345, 0.5};
    fix.covariance = {1e-4, 0.0, 1e-4};
    fix.reportsPerSecond = 10.0;
    fix.age_s = 0.1;
    fix.ranges = {{0, 1.5, 0.01, false}, {7, 3.9, 0.3, true}};
    fix.r95_m = 0.043;
    UwbTagSnapshot stranger;
    stranger.id = 5;
    stranger.reason = "No anchor that is known is in its reports";
    uwb.tags = {fix, stranger};
    return uwb;
}

inline QString cell(const QAbstractItemModel& model, int row, int column)
{
    return model.index(row, column).data().toString();
}

inline bool enter(QAbstractItemModel& model, int row, int column, const QString& text)
{
    return model.setData(model.index(row, column), text, Qt::EditRole);
}

inline std::vector<AgvConfig> twoAgvs()
{
    AgvConfig one;
    one.id = {1};
    one.name = "Mover";
    AgvConfig two;
    two.id = {2};
    return {one, two};
}

} // namespace agv::kit
