// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console_window.h"

#include "app/desktop_watch.h"
#include "app/display_probe.h"
#include "app/plant_source.h"
#include "app/session_thread.h"
#include "app/signal_watch.h"
#include "app/simulated_plant.h"
#include "app/sleeptime_file.h"
#include "app/uwb_requests.h"
#include "gui/application_setup.h"
#include "gui/main_window.h"
#include "gui/plant_file_dialog.h"
#include "session/alarm_desk.h"
#include "session/jog_desk.h"

#include <QApplication>
#include <QFile>

#include <chrono>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace agv::app {
namespace {

int complain(const std::string& text)
{
    std::fprintf(stderr, "agv-console: %s\n", text.c_str());
    return 1;
}

/// On a platform without a screen a dialog would wait for ever.
bool somebodyCanAnswer()
{
    const QString platform = QGuiApplication::platformName();
    return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal");
}

/// The plant to use; none when the operator gives up. A bad file is said on stderr and in a dialog.
std::optional<LoadedPlant> loadPlantWithHelp(PlantChoice& choice)
{
    while (true) {
        Result<LoadedPlant> plant = loadPlant(choice);
        if (plant)
            return std::move(*plant);
        complain(plant.error().detail);
        if (!somebodyCanAnswer())
            return std::nullopt;
        gui::PlantFileDialog dialog(QString::fromStdString(plant.error().detail));
        dialog.exec();
        switch (dialog.choice()) {
        case gui::PlantFileDialog::Choice::Quit:
            return std::nullopt;
        case gui::PlantFileDialog::Choice::BuiltInPlant:
            choice.plantFile.reset();
            break;
        case gui::PlantFileDialog::Choice::OtherFile:
            if (const QString file = gui::PlantFileDialog::askForFile(); !file.isEmpty())
                choice.plantFile = QFile::encodeName(file).toStdString();
            break;
        }
    }
}

EventEntry consoleEvent(EventLevel level, const std::string& text)
{
    using namespace std::chrono;
    const auto now = duration_cast<milliseconds>(system_clock::now().time_since_epoch());
    return {now.count(), level, "Console", text};
}

/// What the operator's hand holds. The words of a press keep their order, because one queue carries them.
void wireJog(gui::MainWindow& window, session::JogDesk& desk)
{
    using gui::MainWindow;
    using session::JogDesk;
    QObject::connect(&window, &MainWindow::jogPressed, &desk, &JogDesk::press);
    QObject::connect(&window, &MainWindow::jogHeld, &desk, &JogDesk::hold);
    QObject::connect(&window, &MainWindow::jogReleased, &desk, &JogDesk::release);
    QObject::connect(&window, &MainWindow::stopRequested, &desk, &JogDesk::stop);
    QObject::connect(&window, &MainWindow::dockRequested, &desk, &JogDesk::order);
    QObject::connect(&window, &MainWindow::stopAllReleased, &desk, &JogDesk::releaseStopAll);
}

/// Requests go down to the session, snapshots and events come up; all queued, by value.
void wire(gui::MainWindow& window, session::Session& session)
{
    using gui::MainWindow;
    using session::Session;
    QObject::connect(&window, &MainWindow::openReaderRequested, &session, &Session::openReader);
    QObject::connect(&window, &MainWindow::closeReaderRequested, &session, &Session::closeReader);
    QObject::connect(&window, &MainWindow::startTurnRequested, &session, &Session::startTurn);
    QObject::connect(&window, &MainWindow::abortTurnRequested, &session,
                     [&session](int robot) { session.abortTurn(robot, "The operator aborted it"); });
    QObject::connect(&window, &MainWindow::retakeStopRequested, &session, &Session::retakeStop);
    QObject::connect(&window, &MainWindow::turnTimeChanged, &session, &Session::setTurnTime);
    QObject::connect(&window, &MainWindow::turnSpeedChanged, &session, &Session::setTurnSpeed);
    QObject::connect(&window, &MainWindow::stopAllRequested, &session,
                     [&session] { session.stopAll("Stop all was pressed"); });
    session::AlarmDesk& alarms = session.alarms();
    QObject::connect(&window, &MainWindow::acknowledgeAlarmsRequested, &alarms,
                     &session::AlarmDesk::acknowledge);
    QObject::connect(&window, &MainWindow::shelveAlarmsRequested, &alarms, &session::AlarmDesk::shelve);
    QObject::connect(&window, &MainWindow::unshelveAlarmsRequested, &alarms, &session::AlarmDesk::unshelve);
    wireJog(window, *session.jogDesk());
    QObject::connect(&session, &Session::snapshotReady, &window, &MainWindow::showSnapshot);
    QObject::connect(&session, &Session::listenFailed, &window, &MainWindow::showListenFailure);
    QObject::connect(&session, &Session::listening, &window, &MainWindow::showListening);
    QObject::connect(&session, &Session::eventLogged, &window, &MainWindow::addEvent);
}

/// The window, its session and the simulated plant, made in the order in which they get ready.
class Console {
public:
    Console(const WindowArguments& arguments, LoadedPlant plant)
        : m_arguments(arguments),
          m_plant(std::move(plant))
    {
        QObject::connect(&m_signals, &SignalWatch::caught,
                         [](int number) { QCoreApplication::exit(SignalWatch::exitStatus(number)); });
    }

    int run()
    {
        if (m_arguments.plant.simulate)
            startSimulation();
        else
            startConsole();
        const int status = QCoreApplication::exec();
        m_uwbRequests.reset();
        m_session.reset(); // stops the robots before the simulated ones vanish
        m_window.reset();
        return status;
    }

private:
    void startSimulation()
    {
        m_simulated = std::make_unique<SimulatedPlant>(m_arguments.plant);
        QObject::connect(m_simulated.get(), &SimulatedPlant::ready, [this] {
            m_plant.layout = m_simulated->adapted(m_plant.layout);
            startConsole();
        });
        QObject::connect(m_simulated.get(), &SimulatedPlant::died, [this](const QString& reason) {
            if (m_window) {
                m_window->addEvent(consoleEvent(EventLevel::Error, reason.toStdString()));
                m_window->showSimulationEnd(reason);
            } else {
                QCoreApplication::exit(complain(reason.toStdString()));
            }
        });
        m_simulated->start();
    }

    void startConsole()
    {
        m_window = std::make_unique<gui::MainWindow>(m_plant.layout);
        m_session = std::make_unique<SessionThread>(
            m_plant.layout, session::SessionOptions{m_arguments.plant.simulate, m_arguments.plant.seed});
        session::Session* session = m_session->session();
        wire(*m_window, *session);
        QObject::connect(&m_desktop, &DesktopWatch::screenLocked, session->jogDesk(),
                         [desk = session->jogDesk()] { desk->endAll(JogReason::ScreenLocked); });
        QObject::connect(&m_desktop, &DesktopWatch::aboutToSleep, session->jogDesk(),
                         [desk = session->jogDesk()] { desk->endAll(JogReason::Suspended); });
        m_uwbRequests = std::make_unique<UwbRequests>(*m_window, *session, m_plant.layout, fileForEdits());
        if (m_simulated) {
            QObject::connect(m_window.get(), &gui::MainWindow::simulationCommandRequested, m_simulated.get(),
                             [this](const QString& command) { m_simulated->command(command.toUtf8()); });
        }
        QObject::connect(m_window.get(), &gui::MainWindow::turnTimeApplied, m_window.get(),
                         [this](int robot, double turnTime_s, double turnSpeed_m_s) {
                             keepTurnTime(robot, turnTime_s, turnSpeed_m_s);
                         });
        for (const std::string& warning : m_plant.warnings)
            m_window->addEvent(consoleEvent(EventLevel::Warning, warning));
        QObject::connect(session, &session::Session::listening, m_window.get(),
                         [this](quint16 port, quint16 telemetryPort) {
                             if (m_simulated)
                                 m_simulated->connectConsole("127.0.0.1", port, telemetryPort);
                         });
        m_session->start();
        for (const AgvConfig& agv : m_plant.layout.agvs)
            QMetaObject::invokeMethod(session,
                                      [session, robot = agv.id.number] { session->openReader(robot); });
        QMetaObject::invokeMethod(session, &session::Session::openUwb);
        m_window->show();
    }

    /// Of a simulated plant nothing is kept.
    std::optional<std::filesystem::path> fileForEdits() const
    {
        const PlantChoice& plant = m_arguments.plant;
        return plant.simulate || !plant.plantFile ? std::nullopt
                                                  : std::optional<std::filesystem::path>(*plant.plantFile);
    }

    /// Into the plant file, if there is one for a real plant; the operator sees where it went.
    void keepTurnTime(int robot, double turnTime_s, double turnSpeed_m_s)
    {
        const PlantChoice& plant = m_arguments.plant;
        if (plant.simulate || !plant.plantFile) {
            m_window->showTurnTimeKept(
                robot, EventLevel::Info,
                plant.simulate
                    ? QStringLiteral("The sleeptime holds for this session only: the plant is simulated")
                    : QStringLiteral("The sleeptime holds for this session only: there is no plant file"));
            return;
        }
        const auto whole_ms = [](double seconds) { return QString::number(std::lround(seconds * 1e3)); };
        const Result<double> before_s =
            writeSleeptime(*plant.plantFile, RobotId{robot}, turnTime_s, turnSpeed_m_s);
        if (before_s)
            m_window->showTurnTimeKept(robot, EventLevel::Info,
                                       QStringLiteral("Sleeptime %1 ms is written to %2; there it was %3 ms")
                                           .arg(whole_ms(turnTime_s),
                                                QString::fromStdString(*plant.plantFile),
                                                whole_ms(*before_s)));
        else
            m_window->showTurnTimeKept(robot, EventLevel::Error,
                                       QStringLiteral("The sleeptime holds for this session only: %1")
                                           .arg(QString::fromStdString(before_s.error().detail)));
    }

    WindowArguments m_arguments;
    LoadedPlant m_plant;
    SignalWatch m_signals;
    DesktopWatch m_desktop;
    std::unique_ptr<SimulatedPlant> m_simulated;
    std::unique_ptr<gui::MainWindow> m_window;
    std::unique_ptr<SessionThread> m_session;
    std::unique_ptr<UwbRequests> m_uwbRequests;
};

} // namespace

int runHasDisplay()
{
    const std::optional<std::string> trouble = displayTrouble();
    return trouble ? complain(*trouble) : 0;
}

int runWindow(const WindowArguments& arguments, int& argc, char** argv)
{
    if (const std::optional<std::string> trouble = displayTrouble())
        return complain(*trouble + "; \"agv-console calibrate\" does the same job in the terminal");
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // files and logs; the screen goes by QLocale
    gui::setUpApplication(application, QLocale());
    WindowArguments chosen = arguments;
    std::optional<LoadedPlant> plant = loadPlantWithHelp(chosen.plant);
    if (!plant)
        return 1;
    return Console(chosen, std::move(*plant)).run();
}

} // namespace agv::app
