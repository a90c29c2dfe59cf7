// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the dead-man's class comment, cell by cell.
#include "procedure/jog_words.h"

#include <functional>
#include <string>
#include <vector>

using namespace agv;
using namespace agv::procedure;
using namespace agv::procedure::jog_test;

namespace {

struct Cell {
    JogState next;
    JogAction action;
};
struct Row {
    const char* event;
    std::function<JogAction(JogDeadMan&)> happen;
    Cell ready, driving, spent, latched;
};

const std::vector<Row>& table()
{
    static const std::vector<Row> rows = {
        {"press",
         [](JogDeadMan& m) { return m.press(command(2, soon), JogReason::None, soon); },
         {driving, drive},
         {driving, drive},
         {driving, drive},
         {latched, nothing}},
        {"press of another source",
         [](JogDeadMan& m) {
             return m.press(command(2, soon, ahead, JogSource::Keys), JogReason::None, soon);
         },
         {driving, drive},
         {driving, nothing},
         {driving, drive},
         {latched, nothing}},
        {"press with an obstacle",
         [](JogDeadMan& m) { return m.press(command(2, soon), JogReason::TurnRuns, soon); },
         {ready, nothing},
         {spent, stop},
         {spent, nothing},
         {latched, nothing}},
        {"press that is too old",
         [](JogDeadMan& m) { return m.press(command(2, soon - 250ms), JogReason::None, soon); },
         {ready, nothing},
         {spent, stop},
         {spent, nothing},
         {latched, nothing}},
        {"press of nothing",
         [](JogDeadMan& m) { return m.press(command(2, soon, {}), JogReason::None, soon); },
         {ready, nothing},
         {spent, stop},
         {spent, nothing},
         {latched, nothing}},
        {"hold",
         [](JogDeadMan& m) { return m.hold(command(1, soon, curve), soon); },
         {ready, nothing},
         {driving, nothing},
         {spent, nothing},
         {latched, nothing}},
        {"hold that is too old",
         [](JogDeadMan& m) { return m.hold(command(1, soon - 250ms), soon); },
         {ready, nothing},
         {spent, stop},
         {spent, nothing},
         {latched, nothing}},
        {"hold of nothing",
         [](JogDeadMan& m) { return m.hold(command(1, soon, {}), soon); },
         {ready, nothing},
         {spent, stop},
         {spent, nothing},
         {latched, nothing}},
        {"hold of another press",
         [](JogDeadMan& m) { return m.hold(command(2, soon), soon); },
         {ready, nothing},
         {driving, nothing},
         {spent, nothing},
         {latched, nothing}},
        {"hold of another source",
         [](JogDeadMan& m) { return m.hold(command(1, soon, ahead, JogSource::Keys), soon); },
         {ready, nothing},
         {driving, nothing},
         {spent, nothing},
         {latched, nothing}},
        {"release",
         [](JogDeadMan& m) { return m.release(command(1, soon), JogReason::Released); },
         {ready, nothing},
         {ready, stop},
         {ready, nothing},
         {latched, nothing}},
        {"release of another press",
         [](JogDeadMan& m) { return m.release(command(2, soon), JogReason::Released); },
         {ready, nothing},
         {driving, nothing},
         {spent, nothing},
         {latched, nothing}},
        {"release of another source",
         [](JogDeadMan& m) {
             return m.release(command(1, soon, ahead, JogSource::Keys), JogReason::Released);
         },
         {ready, nothing},
         {driving, nothing},
         {spent, nothing},
         {latched, nothing}},
        {"obstruct",
         [](JogDeadMan& m) { return m.obstruct(JogReason::LinkLost); },
         {ready, nothing},
         {spent, stop},
         {spent, nothing},
         {latched, nothing}},
        {"stop all",
         [](JogDeadMan& m) {
             m.stopAll();
             return nothing;
         },
         {latched, nothing},
         {latched, nothing},
         {latched, nothing},
         {latched, nothing}},
        {"release of Stop all",
         [](JogDeadMan& m) {
             m.releaseLatch();
             return nothing;
         },
         {ready, nothing},
         {driving, nothing},
         {spent, nothing},
         {ready, nothing}},
        {"timer before anything is due",
         [](JogDeadMan& m) { return m.onTimer(start + 49ms); },
         {ready, nothing},
         {driving, nothing},
         {spent, nothing},
         {latched, nothing}},
        {"timer with a command due",
         [](JogDeadMan& m) { return m.onTimer(start + 50ms); },
         {ready, nothing},
         {driving, drive},
         {spent, nothing},
         {latched, nothing}},
        {"timer with a silent hand",
         [](JogDeadMan& m) { return m.onTimer(start + 250ms); },
         {ready, nothing},
         {spent, stop},
         {spent, nothing},
         {latched, nothing}},
    };
    return rows;
}

} // namespace

TEST(JogDeadMan, followsItsTableInEveryStateForEveryEvent)
{
    for (const Row& row : table()) {
        const std::pair<JogState, Cell> cells[] = {
            {ready, row.ready}, {driving, row.driving}, {spent, row.spent}, {latched, row.latched}};
        for (const auto& [state, expected] : cells) {
            SCOPED_TRACE(std::string(row.event) + " in state " + std::to_string(static_cast<int>(state)));
            JogDeadMan machine = machineIn(state);
            EXPECT_EQ(row.happen(machine), expected.action);
            EXPECT_EQ(machine.state(), expected.next);
            EXPECT_EQ(machine.deadline().has_value(), expected.next == driving);
        }
    }
}

TEST(JogDeadMan, everyEventThatEndsDrivingSaysZeroOrLeavesItToStopAll)
{
    for (const Row& row : table()) {
        JogDeadMan machine = machineIn(driving);
        const JogAction action = row.happen(machine);
        if (machine.state() == driving || machine.state() == latched)
            continue;
        EXPECT_EQ(action, stop) << row.event;
    }
}

TEST(JogDeadMan, nothingButAPressMakesAStandingAgvDrive)
{
    for (const Row& row : table()) {
        for (const JogState state : {ready, spent, latched}) {
            JogDeadMan machine = machineIn(state);
            const bool drives = row.happen(machine) == drive;
            EXPECT_TRUE(!drives || std::string(row.event).starts_with("press")) << row.event;
        }
    }
}
