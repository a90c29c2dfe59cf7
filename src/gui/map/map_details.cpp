// SPDX-License-Identifier: GPL-3.0-or-later
// What the map says about the thing under the pointer.
#include "gui/map/map_widget.h"

#include "gui/map/accuracy_layer.h"
#include "model/messages.h"
#include "model/uncertainty.h"
#include "model/words.h"

#include <algorithm>

namespace agv::gui {

using model::Words;

namespace {

constexpr double reach_px = 9.0;

double pixelsApart(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

} // namespace

const AgvSnapshot* MapWidget::agvAt(QPointF pixel) const
{
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        const AgvConfig* config = m_plant.findAgv(agv.id);
        const std::optional<Pose2> pose = drawnPose(agv.id.number);
        if (config && pose && distance(m_viewport.toPlant(pixel), pose->position) <= config->radius_m)
            return &agv;
    }
    return nullptr;
}

QString MapWidget::detailsAt(QPointF pixel) const
{
    if (const QString unknown = unknownTagDetails(pixel); !unknown.isEmpty())
        return unknown;
    if (const QString stop = stopDetails(pixel); !stop.isEmpty())
        return stop;
    if (const QString tag = uwbTagDetails(pixel); !tag.isEmpty())
        return tag;
    if (const QString anchor = anchorDetails(pixel); !anchor.isEmpty())
        return anchor;
    if (const QString tag = tagDetails(pixel); !tag.isEmpty() && !agvAt(pixel))
        return tag;
    if (const AgvSnapshot* agv = agvAt(pixel))
        return agvDetails(*agv);
    if (const QString station = stationDetails(pixel); !station.isEmpty())
        return station;
    return accuracyDetails(pixel);
}

QString MapWidget::agvDetails(const AgvSnapshot& agv) const
{
    const std::optional<Pose2> pose = drawnPose(agv.id.number);
    QStringList lines{agv.name.empty() ? tr("AGV %1").arg(agv.id.number) : QString::fromStdString(agv.name)};
    if (pose) {
        lines << tr("x %1, y %2, facing %3")
                     .arg(Words::millimetres(pose->position.x), Words::millimetres(pose->position.y),
                          Words::degrees(pose->heading, 1));
    }
    if (!agv.poseNote.empty())
        lines << model::Messages::sentence(agv.poseNote);
    lines << Words::robotState(isConnected(agv.robotLink), agv.robotState);
    if (agv.battery)
        lines << tr("Battery %1").arg(Words::volts(agv.battery->voltage_V));
    if (agv.mayBeMoving)
        lines << tr("May be moving: the connection was lost while the wheels were turning.");
    return lines.join(QLatin1Char('\n'));
}

QString MapWidget::stopDetails(QPointF pixel) const
{
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        const TurnEstimate* estimate = model::shownEstimate(agv);
        if (!estimate)
            continue;
        for (std::size_t i = 0; i < estimate->stops.size(); ++i) {
            const StopReport& stop = estimate->stops[i];
            if (pixelsApart(m_viewport.toPixels(stop.antenna), pixel) > reach_px)
                continue;
            return tr("AGV %1, stop %2: antenna at x %3, y %4\nTags expected %5, seen %6, missed %7, unknown "
                      "%8")
                .arg(agv.id.number)
                .arg(i + 1)
                .arg(Words::millimetres(stop.antenna.x), Words::millimetres(stop.antenna.y))
                .arg(stop.expected.size())
                .arg(stop.seen.size())
                .arg(stop.missed.size())
                .arg(stop.unknown.size() + stop.misplaced.size());
        }
    }
    return {};
}

const FloorTag* MapWidget::floorTagAt(QPointF pixel) const
{
    if (!layers().floorTags)
        return nullptr;
    const FloorTag* nearest = nullptr;
    double best = std::max(reach_px, m_viewport.toPixels(m_plant.tagRadius_m));
    for (const FloorTag& tag : m_plant.floorTags) {
        const double apart = pixelsApart(m_viewport.toPixels(tag.position), pixel);
        if (apart <= best) {
            best = apart;
            nearest = &tag;
        }
    }
    return nearest;
}

QString MapWidget::tagDetails(QPointF pixel) const
{
    const FloorTag* tag = floorTagAt(pixel);
    if (!tag)
        return {};
    QStringList lines{tr("Floor tag %1 (%2)\n%3\nx %4, y %5")
                          .arg(tag->number)
                          .arg(QString::fromStdString(shortText(tag->uid)),
                               QString::fromStdString(fullText(tag->uid)),
                               Words::millimetres(tag->position.x), Words::millimetres(tag->position.y))};
    switch (m_tagStates.stateOf(tag->uid)) {
    case model::FloorTagState::SeenNow:
    case model::FloorTagState::SeenBefore:
        lines << tr("Seen in this session");
        break;
    case model::FloorTagState::Missing:
        lines << tr("Missing: a turn should have read it and did not");
        break;
    case model::FloorTagState::NotSeen:
    case model::FloorTagState::Unknown:
        break;
    }
    return lines.join(QLatin1Char('\n'));
}

QString MapWidget::unknownTagDetails(QPointF pixel) const
{
    for (const model::FloorTagStates::Unknown& unknown : m_tagStates.unknown()) {
        if (pixelsApart(m_viewport.toPixels(unknown.antenna), pixel) <= reach_px)
            return tr("Unknown floor tag %1 was read here; the plant file does not name it")
                .arg(QString::fromStdString(fullText(unknown.uid)));
    }
    return {};
}

QString MapWidget::accuracyDetails(QPointF pixel) const
{
    if (!layers().accuracy || m_plant.anchors.empty())
        return {};
    const std::optional<double> radius = expectedUwbRadius(m_plant, m_viewport.toPlant(pixel));
    return radius ? tr("UWB positions here: 95 % within about %1, as the anchors stand")
                        .arg(Words::millimetres(*radius))
                  : tr("No UWB position here: the anchors stand too much in one direction");
}

const UwbTagSnapshot* MapWidget::uwbTagAt(QPointF pixel) const
{
    if (!m_snapshot.uwb || !layers().uwbTags)
        return nullptr;
    for (const UwbTagSnapshot& tag : m_snapshot.uwb->tags) {
        if (tag.position && pixelsApart(m_viewport.toPixels(*tag.position), pixel) <= reach_px)
            return &tag;
    }
    return nullptr;
}

QString MapWidget::uwbTagDetails(QPointF pixel) const
{
    const UwbTagSnapshot* tag = uwbTagAt(pixel);
    if (!tag)
        return {};
    const model::Ellipse95 ellipse = model::ellipse95(tag->covariance);
    QStringList lines{tag->label.empty()
                          ? tr("UWB tag %1").arg(tag->id)
                          : tr("UWB tag %1, %2").arg(tag->id).arg(QString::fromStdString(tag->label))};
    if (tag->agv)
        lines << tr("On AGV %1").arg(tag->agv->number);
    lines << tr("x %1, y %2, 95 % within %3 by %4")
                 .arg(Words::millimetres(tag->position->x), Words::millimetres(tag->position->y),
                      Words::millimetres(ellipse.major_m), Words::millimetres(ellipse.minor_m));
    lines << tr("%1 ranges, %2 of them obstructed")
                 .arg(tag->ranges.size())
                 .arg(std::ranges::count(tag->ranges, true, &UwbRangeSnapshot::rejected));
    lines << tr("%1, %2 exchanges missed").arg(Words::rate(tag->reportsPerSecond)).arg(tag->missed);
    return lines.join(QLatin1Char('\n'));
}

const UwbAnchor* MapWidget::anchorAt(QPointF pixel) const
{
    if (!layers().anchors)
        return nullptr;
    for (const UwbAnchor& anchor : m_plant.anchors) {
        if (anchor.shown && pixelsApart(m_viewport.toPixels(Point2{anchor.x, anchor.y}), pixel) <= reach_px)
            return &anchor;
    }
    return nullptr;
}

QString MapWidget::anchorDetails(QPointF pixel) const
{
    const UwbAnchor* anchor = anchorAt(pixel);
    if (!anchor)
        return {};
    return tr("UWB anchor %1, %2\nx %3, y %4, height %5")
        .arg(anchor->id)
        .arg(QString::fromStdString(anchor->label), Words::millimetres(anchor->x),
             Words::millimetres(anchor->y), Words::millimetres(anchor->z));
}

QString MapWidget::stationDetails(QPointF pixel) const
{
    const Point2 p = m_viewport.toPlant(pixel);
    for (const Station& station : m_plant.stations) {
        const Point2 offset = p - station.pose.position;
        const double c = std::cos(station.pose.heading);
        const double s = std::sin(station.pose.heading);
        if (std::abs(c * offset.x + s * offset.y) > 0.5 * station.width_m ||
            std::abs(-s * offset.x + c * offset.y) > 0.5 * station.depth_m)
            continue;
        return tr("Station %1\nx %2, y %3")
            .arg(QString::fromStdString(station.name), Words::millimetres(station.pose.position.x),
                 Words::millimetres(station.pose.position.y));
    }
    return {};
}

} // namespace agv::gui
