// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/shift_log.h"

#include "gui/result_text.h"
#include "model/words.h"

namespace agv::gui {

using model::Words;

namespace {

EventEntry entry(const AgvSnapshot& agv, EventLevel level, const QString& text)
{
    return {0, level, "AGV " + std::to_string(agv.id.number), text.toStdString()};
}

} // namespace

std::vector<EventEntry> ShiftLog::linesFor(const PlantSnapshot& snapshot, std::int64_t utc_ms)
{
    std::vector<EventEntry> lines;
    for (const AgvSnapshot& agv : snapshot.agvs) {
        const auto [found, isNew] = m_known.try_emplace(agv.id.number);
        Known& known = found->second;
        if (agv.turn.result && agv.turn.result != known.result)
            lines.push_back(outcome(agv, *agv.turn.result));
        if (!isNew && agv.turnSpeed_m_s != known.turnSpeed_m_s) {
            lines.push_back(entry(agv, EventLevel::Info,
                                  tr("Wheel speed of its turns changed from %1 to %2")
                                      .arg(Words::millimetresPerSecond(known.turnSpeed_m_s),
                                           Words::millimetresPerSecond(agv.turnSpeed_m_s))));
        }
        if (!isNew && agv.turnTime_s != known.turnTime_s) {
            lines.push_back(
                entry(agv, EventLevel::Info,
                      tr("Sleeptime changed from %1 to %2")
                          .arg(Words::milliseconds(known.turnTime_s), Words::milliseconds(agv.turnTime_s))));
        }
        known = {agv.turn.result, agv.turnTime_s, agv.turnSpeed_m_s};
    }
    for (EventEntry& line : lines)
        line.utc_ms = utc_ms;
    return lines;
}

EventEntry ShiftLog::outcome(const AgvSnapshot& agv, const TurnEstimate& estimate)
{
    const Verdict verdict = ResultText::verdict(estimate);
    const QString pose = ResultText::shortForm(estimate);
    return entry(agv,
                 verdict == Verdict::Good      ? EventLevel::Info
                 : verdict == Verdict::Warning ? EventLevel::Warning
                                               : EventLevel::Error,
                 ResultText::headline(estimate) + (pose.isEmpty() ? QString() : QStringLiteral(": ") + pose));
}

} // namespace agv::gui
