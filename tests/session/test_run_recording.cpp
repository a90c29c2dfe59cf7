// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scripted_plant.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "session/read_back.h"

#include <algorithm>
#include <filesystem>

namespace agv::session {
namespace {

RecordingOptions into(const QTemporaryDir& folder)
{
    RecordingOptions options;
    options.runs = folder.path().toStdString();
    options.software = "agv-console test";
    return options;
}

bool contains(const std::vector<std::string>& texts, std::string_view part)
{
    return std::ranges::any_of(texts,
                               [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

std::vector<std::filesystem::path> foldersIn(const QTemporaryDir& folder)
{
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path().toStdString()))
        found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

} // namespace

class RunRecordingTest : public QObject {
    Q_OBJECT
private slots:
    void aRunHoldsEverythingThatPassedWhileItWasOn()
    {
        const QTemporaryDir folder;
        ScriptedPlant plant(SolveMethod::Fast, into(folder));
        std::string bytes;
        connect(plant.session.get(), &Session::readerBytes, this,
                [&](int, const QByteArray& more) { bytes += more.toStdString(); });
        plant.session->startRun("with \"quotes\"");
        QVERIFY(plant.bringUp());
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, 20000);
        QTRY_COMPARE_WITH_TIMEOUT(plant.agv().turn.phase, TurnPhase::Finished, patience_ms);
        QVERIFY(plant.agv().pose.has_value());
        QTRY_VERIFY_WITH_TIMEOUT(plant.last.recording.bytes > 0, patience_ms);
        QCOMPARE(plant.last.recording.state, RecordingState::Recording);
        QVERIFY(plant.last.recording.elapsed_s > 0.0);
        plant.session->stopRun();
        const std::string recorded = bytes;
        QTRY_VERIFY_WITH_TIMEOUT(plant.logged(EventLevel::Info, "The recording is in"), patience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(plant.last.recording.state, RecordingState::Off, patience_ms);

        auto run = recording::RunReader::open(plant.last.recording.folder);
        QVERIFY2(run, run ? "" : run.error().detail.c_str());
        QCOMPARE(run->info().note, std::string("with \"quotes\""));
        QCOMPARE(run->info().startedBy, std::string("operator"));
        QVERIFY(run->info().ended_utc_ms.has_value());
        QVERIFY(run->plant()->agvs.size() == 1);
        QVERIFY(recordedBytes(*run, "reader 1") == recorded);
        QVERIFY(!recordedBytes(*run, "robot 1 sent").empty());
        QCOMPARE(recordedRows(*run, "floor_reads"),
                 static_cast<std::uint64_t>(std::ranges::count(recorded, '+')) / 2);
        QCOMPARE(recordedRows(*run, "wheel_commands"), std::uint64_t{16}); // eight turns, each ended
        QCOMPARE(recordedRows(*run, "turn_results"), std::uint64_t{1});
        QVERIFY(recordedRows(*run, "turn_steps") >= 17);
        QVERIFY(recordedRows(*run, "poses") >= 1);
        QVERIFY(contains(recordedTexts(*run, "operator_actions", 0), "start turn"));
        QVERIFY(contains(recordedTexts(*run, "operator_actions", 2), "8 stops"));
        QVERIFY(contains(recordedTexts(*run, "events", 2), "Initialisation turn started"));
    }

    void aRunIsWholeWhenTheConsoleEndsInTheMiddle()
    {
        const QTemporaryDir folder;
        ScriptedPlant plant(SolveMethod::Fast, into(folder));
        plant.session->startRun();
        QVERIFY(plant.bringUp());
        plant.endSession();
        auto run = recording::RunReader::open(foldersIn(folder).front());
        QVERIFY(run);
        QVERIFY(run->info().ended_utc_ms.has_value());
        QVERIFY(recordedRows(*run, "floor_reads") > 0);
    }

    void aRemovedFolderStopsTheRecordingAndNothingElse()
    {
        const QTemporaryDir folder;
        ScriptedPlant plant(SolveMethod::Fast, into(folder));
        plant.session->startRun();
        QVERIFY(plant.bringUp());
        QTRY_VERIFY_WITH_TIMEOUT(plant.last.recording.bytes > 0, patience_ms);
        std::filesystem::remove_all(plant.last.recording.folder);
        QTRY_COMPARE_WITH_TIMEOUT(plant.last.recording.state, RecordingState::Failed, patience_ms);
        QVERIFY(plant.last.recording.reason.find("was removed") != std::string::npos);
        QVERIFY(plant.logged(EventLevel::Error, "The recording has stopped: "));
        const std::uint64_t received = plant.agv().readerLink.received;
        QTRY_VERIFY_WITH_TIMEOUT(plant.agv().readerLink.received > received, patience_ms);
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, 20000);
        QCOMPARE(plant.ended[0].phase, TurnPhase::Finished);
        // And it can be recorded again.
        plant.session->startRun();
        QTRY_COMPARE_WITH_TIMEOUT(plant.last.recording.state, RecordingState::Recording, patience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(plant.last.recording.bytes > 0, patience_ms);
    }

    void aFolderThatCannotBeMadeIsSaid()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath("file"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        RecordingOptions options = into(folder);
        options.runs = options.runs / "file";
        options.ring = true;
        ScriptedPlant plant(SolveMethod::Fast, options);
        plant.session->startRun();
        QTRY_COMPARE_WITH_TIMEOUT(plant.last.recording.state, RecordingState::Failed, patience_ms);
        QVERIFY(plant.logged(EventLevel::Error, "choose another folder"));
        QVERIFY(plant.logged(EventLevel::Warning, "The last minutes are no longer kept"));
        QVERIFY(!plant.last.recording.canKeep);
        plant.session->keepRecent();
        QVERIFY(plant.logged(EventLevel::Error, "The last minutes are not kept"));
    }

    void withoutAFolderNothingIsRecordedAndThatIsSaid()
    {
        ScriptedPlant plant;
        plant.session->startRun();
        QTRY_COMPARE_WITH_TIMEOUT(plant.last.recording.state, RecordingState::Failed, patience_ms);
        QVERIFY(plant.logged(EventLevel::Error, "there is no folder"));
    }

    void aDiskThatDoesNotKeepUpStopsTheRecording()
    {
        const QTemporaryDir folder;
        RecordingOptions options = into(folder);
        options.mostPending = 1;
        ScriptedPlant plant(SolveMethod::Fast, options);
        plant.session->startRun();
        QVERIFY(plant.bringUp());
        QTRY_COMPARE_WITH_TIMEOUT(plant.last.recording.state, RecordingState::Failed, patience_ms);
        QVERIFY(plant.logged(EventLevel::Error, "too slow"));
    }

    void everyTurnIsARunWhereThatIsWanted()
    {
        const QTemporaryDir folder;
        RecordingOptions options = into(folder);
        options.everyTurn = true;
        ScriptedPlant plant(SolveMethod::Fast, options);
        plant.session->startTurn(1, ScriptedPlant::quickTurn()); // refused: nothing is connected
        QTRY_VERIFY_WITH_TIMEOUT(plant.logged(EventLevel::Info, "The recording is in"), patience_ms);
        QVERIFY(plant.bringUp());
        plant.session->startTurn(1, ScriptedPlant::quickTurn());
        QTRY_COMPARE_WITH_TIMEOUT(plant.ended.size(), std::size_t{1}, 20000);
        QTRY_COMPARE_WITH_TIMEOUT(plant.last.recording.state, RecordingState::Off, patience_ms);
        const std::string last = plant.last.recording.folder;
        plant.endSession();
        auto run = recording::RunReader::open(last);
        QVERIFY(run);
        QCOMPARE(run->info().startedBy, std::string("turn"));
        QCOMPARE(recordedRows(*run, "turn_results"), std::uint64_t{1});
    }

    void whatHappenedJustNowIsKeptThoughNobodyStartedARecording()
    {
        const QTemporaryDir folder;
        RecordingOptions options = into(folder);
        options.ring = true;
        ScriptedPlant plant(SolveMethod::Fast, options);
        QVERIFY(plant.bringUp());
        QVERIFY(plant.last.recording.canKeep);
        plant.session->keepRecent();
        QTRY_VERIFY_WITH_TIMEOUT(plant.logged(EventLevel::Info, "The last minutes are kept in"), patience_ms);
        QCOMPARE(plant.last.recording.state, RecordingState::Off);
        auto run = recording::RunReader::open(foldersIn(folder).front()); // digits before letters
        QVERIFY2(run, run ? "" : run.error().detail.c_str());
        QCOMPARE(run->info().startedBy, std::string("kept"));
        QVERIFY(recordedRows(*run, "floor_reads") > 0);
        QVERIFY(contains(recordedTexts(*run, "events", 2), "The robot connected"));
    }

    void theRingOfAConsoleThatEndedIsPutAsideAndThatOfARunningOneIsLeftAlone()
    {
        const QTemporaryDir folder;
        RecordingOptions options = into(folder);
        options.ring = true;
        {
            const ScriptedPlant crashed(SolveMethod::Fast, options);
        }
        ScriptedPlant first(SolveMethod::Fast, options);
        QTRY_COMPARE_WITH_TIMEOUT(foldersIn(folder).size(), std::size_t{2}, patience_ms);
        ScriptedPlant second(SolveMethod::Fast, options);
        QTRY_COMPARE_WITH_TIMEOUT(foldersIn(folder).size(), std::size_t{3}, patience_ms);
        const auto folders = foldersIn(folder);
        QCOMPARE(folders[0].filename().string(), std::string(RunStore::earlierRingName));
        QCOMPARE(folders[1].filename().string(), std::string(RunStore::ringName));
        QCOMPARE(folders[2].filename().string(), std::string(RunStore::ringName) + "-2");
        QVERIFY(!second.logged(EventLevel::Warning, ""));
    }
};

} // namespace agv::session

QTEST_GUILESS_MAIN(agv::session::RunRecordingTest)
#include "test_run_recording.moc"
