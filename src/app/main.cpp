// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QStringList>

#include "app/calibrate.h"
#include "app/command_line.h"
#include "app/guard_channel.h"
#include "app/guard_process.h"
#include "app/locate.h"
#include "app/plant_command.h"
#include "app/simulate.h"
#include "app/solve_turn.h"
#include "app/trainer.h"
#ifdef AGV_WITH_WINDOW
#include "app/console_window.h"
#endif

#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>

namespace agv::app {
namespace {

int leave(const ParseExit& exit)
{
    std::fputs(exit.text.toUtf8().constData(), exit.status == 0 ? stdout : stderr);
    return exit.status;
}

QStringList argumentsFrom(int argc, char** argv, int first)
{
    QStringList arguments;
    for (int i = first; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    return arguments;
}

int dispatch(const QString& command, const QStringList& arguments)
{
    if (command == "calibrate") {
        const auto parsed = parseCalibrateArguments(arguments);
        return parsed ? runCalibrate(*parsed) : leave(parsed.error());
    }
    if (command == "simulate") {
        const auto parsed = parseSimulateArguments(arguments);
        return parsed ? runSimulate(*parsed) : leave(parsed.error());
    }
    if (command == "plant") {
        const auto parsed = parsePlantArguments(arguments);
        return parsed ? runPlant(*parsed, std::cout, std::cerr) : leave(parsed.error());
    }
    if (command == "locate" || command == "fuse") {
        const auto parsed =
            command == "fuse" ? parseFuseArguments(arguments) : parseLocateArguments(arguments);
        return parsed ? runLocate(*parsed, std::cin, std::cout, std::cerr) : leave(parsed.error());
    }
    if (command == "trainer") {
        const auto parsed = parseTrainerArguments(arguments);
        return parsed ? runTrainer(*parsed) : leave(parsed.error());
    }
    const auto parsed = parseSolveTurnArguments(arguments);
    return parsed ? runSolveTurn(*parsed, std::cin, std::cout, std::cerr) : leave(parsed.error());
}

// The window and has-display make application objects of their own, but help and usage errors need no
// display.
std::expected<WindowArguments, ParseExit> windowArguments(int argc, char** argv)
{
    int count = 1;
    const QCoreApplication application(count, argv);
    return parseWindowArguments(argumentsFrom(argc, argv, 1));
}

std::optional<ParseExit> hasDisplayExit(int argc, char** argv)
{
    int count = 1;
    const QCoreApplication application(count, argv);
    return parseHasDisplayArguments(argumentsFrom(argc, argv, 2));
}

#ifndef AGV_WITH_WINDOW
int runWithoutWindow()
{
    std::fputs("agv-console: built without its window\n", stderr);
    return 1;
}
#endif

int window(int argc, char** argv)
{
    const auto arguments = windowArguments(argc, argv);
    if (!arguments)
        return leave(arguments.error());
#ifdef AGV_WITH_WINDOW
    return runWindow(*arguments, argc, argv);
#else
    return runWithoutWindow();
#endif
}

int hasDisplay(int argc, char** argv)
{
    if (const auto exit = hasDisplayExit(argc, argv))
        return leave(*exit);
#ifdef AGV_WITH_WINDOW
    return runHasDisplay();
#else
    return runWithoutWindow();
#endif
}

int run(int argc, char** argv)
{
    if (argc == 2 && std::strcmp(argv[1], guardCommand) == 0)
        return runGuard();
    const QString command = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QString();
    if (command == "calibrate" || command == "simulate" || command == "solve-turn" || command == "plant" ||
        command == "trainer" || command == "locate" || command == "fuse") {
        const QCoreApplication application(argc, argv);
        // Qt takes the user's locale; numbers in files and on the terminal have a point.
        std::setlocale(LC_NUMERIC, "C");
        return dispatch(command, argumentsFrom(argc, argv, 2));
    }
    return command == "has-display" ? hasDisplay(argc, argv) : window(argc, argv);
}

/// What a full disk or a reader that went away did not get is a failure, whichever command wrote it.
int checkedOutput(int status)
{
    errno = 0;
    if ((std::fflush(stdout) == 0 && std::ferror(stdout) == 0) || status != 0)
        return status;
    const std::string reason = errno != 0 ? ": " + std::generic_category().message(errno) : std::string();
    std::fprintf(stderr, "agv-console: standard output: cannot be written%s\n", reason.c_str());
    return 1;
}

} // namespace
} // namespace agv::app

int main(int argc, char** argv) { return agv::app::checkedOutput(agv::app::run(argc, argv)); }
