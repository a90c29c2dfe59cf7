// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/calibrate.h"

#include "app/calibration_files.h"
#include "app/calibration_run.h"
#include "app/plant_source.h"
#include "app/session_thread.h"
#include "app/signal_watch.h"
#include "app/verdict_text.h"
#include "core/units.h"
#include "procedure/turn_parameters.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace agv::app {
namespace {

constexpr int wrongUsage = 2;

int complain(const std::string& text)
{
    std::fprintf(stderr, "agv-console calibrate: %s\n", text.c_str());
    return 1;
}

Result<std::vector<AgvConfig>> chosenAgvs(const PlantLayout& plant, std::optional<int> robot)
{
    std::vector<AgvConfig> agvs = plant.agvs;
    if (robot)
        std::erase_if(agvs, [robot](const AgvConfig& agv) { return agv.id.number != *robot; });
    if (!agvs.empty())
        return agvs;
    return failure(ErrorCode::NotFound, robot ? "There is no AGV " + std::to_string(*robot) + " in the plant"
                                              : "There is no AGV in the plant");
}

/// What the plant file lets no AGV do, known before any of them turns.
Result<void> checkTurns(const std::vector<AgvConfig>& agvs, const CalibrateArguments& arguments)
{
    for (const AgvConfig& agv : agvs) {
        const TurnParameters parameters = parametersFor(agv, arguments);
        const std::string label = "AGV " + std::to_string(agv.id.number);
        if (parameters.wheelSpeed_m_s > agv.maxSpeed_m_s)
            return failure(ErrorCode::BadInput,
                           label + " must not be driven faster than its max_speed_mm_s of " +
                               thousands(mmFromMetres(agv.maxSpeed_m_s)) + " mm/s: choose a lower --speed");
        if (Result<void> valid = procedure::validate(parameters); !valid)
            return failure(ErrorCode::BadInput, label + ": " + valid.error().detail + "; set --turn-time");
    }
    return {};
}

/// Everything that lives while the command runs; the pieces are made in the order in which they get ready.
class Command {
public:
    Command(const CalibrateArguments& arguments, LoadedPlant plant, std::vector<AgvConfig> agvs)
        : m_arguments(arguments),
          m_plant(std::move(plant.layout)),
          m_agvs(std::move(agvs))
    {
        QObject::connect(&m_signals, &SignalWatch::caught,
                         [](int number) { QCoreApplication::exit(SignalWatch::exitStatus(number)); });
    }

    int run()
    {
        if (m_arguments.plant.simulate)
            startSimulation();
        else
            startSession();
        const int status = QCoreApplication::exec();
        m_progress.finish();
        m_run.reset();
        m_session.reset(); // stops the robots before the simulated ones vanish
        return status;
    }

private:
    void startSimulation()
    {
        m_simulated = std::make_unique<SimulatedPlant>(m_arguments.plant);
        QObject::connect(m_simulated.get(), &SimulatedPlant::ready, [this] {
            m_plant = m_simulated->adapted(m_plant);
            startSession();
        });
        QObject::connect(m_simulated.get(), &SimulatedPlant::died,
                         [this](const QString& reason) { fail(reason.toStdString()); });
        m_simulated->start();
    }

    void startSession()
    {
        m_session = std::make_unique<SessionThread>(
            m_plant,
            session::SessionOptions{m_arguments.plant.simulate, m_arguments.plant.seed, m_arguments.method});
        session::Session* session = m_session->session();
        m_run =
            std::make_unique<CalibrationRun>(*session, m_simulated.get(), m_agvs, m_arguments, m_progress);
        CalibrationRun* run = m_run.get();
        QObject::connect(session, &session::Session::listening, run,
                         [this, run](quint16 port, quint16 telemetryPort) {
                             if (m_simulated)
                                 m_simulated->connectConsole("127.0.0.1", port, telemetryPort);
                             run->start();
                         });
        QObject::connect(session, &session::Session::listenFailed, run,
                         [this](const QString& reason) { fail(reason.toStdString()); });
        QObject::connect(session, &session::Session::eventLogged, run, [this](const EventEntry& event) {
            if (event.level > EventLevel::Info)
                m_progress.print(event.source + ": " + event.text);
        });
        QObject::connect(run, &CalibrationRun::outcomeKnown, run,
                         [](const CalibrationOutcome& outcome) { report(outcome); });
        QObject::connect(run, &CalibrationRun::finished, run, [this] { finish(); });
        m_session->start();
    }

    static void report(const CalibrationOutcome& outcome)
    {
        const std::string text = outcome.problem.empty() ? verdictText(outcome.label, outcome.turn)
                                                         : outcome.label + ": no pose. " + outcome.problem;
        std::printf("%s\n", text.c_str());
        if (outcome.truth)
            std::printf("%s\n", truthText(outcome).c_str());
        std::fflush(stdout);
    }

    void fail(const std::string& reason)
    {
        m_failed = true;
        complain(reason);
        if (m_run && m_run->isBusy())
            m_run->giveUp(reason);
        else
            QCoreApplication::exit(1);
    }

    void finish()
    {
        const auto& outcomes = m_run->outcomes();
        const bool all = std::ranges::all_of(outcomes, [](const CalibrationOutcome& outcome) {
            return outcome.problem.empty() && outcome.turn.result && outcome.turn.result->valid;
        });
        int status = all && !m_failed ? 0 : 1;
        if (m_arguments.outFolder) {
            if (const auto written = writeCalibration(*m_arguments.outFolder, outcomes, m_arguments.method);
                !written)
                status = complain(written.error().detail);
        }
        QCoreApplication::exit(status);
    }

    CalibrateArguments m_arguments;
    PlantLayout m_plant;
    std::vector<AgvConfig> m_agvs;
    ProgressLine m_progress;
    SignalWatch m_signals;
    bool m_failed = false;
    std::unique_ptr<SimulatedPlant> m_simulated;
    std::unique_ptr<SessionThread> m_session;
    std::unique_ptr<CalibrationRun> m_run;
};

} // namespace

int runCalibrate(const CalibrateArguments& arguments)
{
    Result<LoadedPlant> plant = loadPlant(arguments.plant);
    if (!plant)
        return complain(plant.error().detail);
    for (const std::string& warning : plant->warnings)
        std::fprintf(stderr, "agv-console calibrate: %s\n", warning.c_str());
    Result<std::vector<AgvConfig>> agvs = chosenAgvs(plant->layout, arguments.robot);
    if (!agvs) {
        complain(agvs.error().detail);
        return arguments.robot ? wrongUsage : 1;
    }
    if (const Result<void> valid = checkTurns(*agvs, arguments); !valid) {
        complain(valid.error().detail);
        return wrongUsage;
    }
    if (arguments.outFolder) {
        if (const Result<void> ready = prepareFolder(*arguments.outFolder); !ready)
            return complain(ready.error().detail);
    }
    return Command(arguments, std::move(*plant), std::move(*agvs)).run();
}

} // namespace agv::app
