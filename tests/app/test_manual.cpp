// SPDX-License-Identifier: GPL-3.0-or-later
// docs/manual/command-line.md against the program: every option, and what the examples print.
#include <QFile>
#include <QFileInfo>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include "app/command_line.h"

namespace agv::app {
namespace {

const QRegularExpression optionPattern("--([a-z][a-z-]*)");

QSet<QString> optionsIn(const QString& text)
{
    QSet<QString> options;
    for (auto matches = optionPattern.globalMatch(text); matches.hasNext();)
        options += matches.next().captured(1);
    return options;
}

QString manual()
{
    QFile file(AGV_SOURCE_DIR "/docs/manual/command-line.md");
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The text under a heading of the second level, without the heading.
QString section(const QString& heading)
{
    return manual().section("\n## " + heading + "\n", 1, 1).section("\n## ", 0, 0);
}

/// What the help lists; not those that its sentences mention.
QSet<QString> optionsOfHelp(const QString& help)
{
    QSet<QString> options;
    for (const QString& line : help.split('\n'))
        if (line.startsWith("  -"))
            options += optionsIn(line.trimmed().section("  ", 0, 0));
    return options - QSet<QString>{"help", "version"}; // said once for all
}

const QMap<QString, QString>& helps()
{
    static const QMap<QString, QString> texts{
        {"window", parseWindowArguments({"--help"}).error().text},
        {"calibrate", parseCalibrateArguments({"--help"}).error().text},
        {"solve-turn", parseSolveTurnArguments({"--help"}).error().text},
        {"locate", parseLocateArguments({"--help"}).error().text},
        {"fuse", parseFuseArguments({"--help"}).error().text},
        {"simulate", parseSimulateArguments({"--help"}).error().text},
        {"plant", parsePlantArguments({"--help"}).error().text},
        {"trainer", parseTrainerArguments({"--help"}).error().text},
    };
    return texts;
}

/// Options of the table of those that several commands have, for one of them.
QSet<QString> sharedOptions(const QString& command)
{
    QSet<QString> options;
    for (const QString& line : section("Options of more than one command").split('\n')) {
        const QStringList cells = line.split('|');
        if (cells.size() > 3 && cells[2].contains(command))
            options += optionsIn(cells[1]);
    }
    return options;
}

/// Options of a command's own section: those of its lines of usage and of the first column of its tables.
QSet<QString> ownOptions(const QString& command)
{
    const QString heading = command == "window" ? QStringLiteral("The window") : command;
    QSet<QString> options;
    for (const QString& line : section(heading).split('\n'))
        if (line.startsWith("`agv-console") || line.startsWith('['))
            options += optionsIn(line);
        else if (line.startsWith("| `--"))
            options += optionsIn(line.section('|', 1, 1));
    return options;
}

QString listed(const QSet<QString>& options) { return QStringList(options.values()).join(", "); }

/// The parts between "..." come in this order, the first one at the beginning.
bool fits(const QString& output, const QString& expected)
{
    qsizetype at = 0;
    const QStringList parts = expected.split("...");
    for (const QString& part : parts) {
        const qsizetype found = output.indexOf(part, at);
        if (found < 0 || (&part == &parts.front() && found != 0))
            return false;
        at = found + part.size();
    }
    return parts.size() > 1 || at == output.size();
}

} // namespace

class ManualTest : public QObject {
    Q_OBJECT
private slots:
    void hasEveryOptionOfACommandAndNoOther_data()
    {
        QTest::addColumn<QString>("command");
        for (const QString& command : helps().keys())
            QTest::newRow(qPrintable(command)) << command;
    }
    void hasEveryOptionOfACommandAndNoOther()
    {
        QFETCH(QString, command);
        const QSet<QString> program = optionsOfHelp(helps()[command]);
        QVERIFY(!program.isEmpty());
        const QSet<QString> described = ownOptions(command) + sharedOptions(command);
        QVERIFY2((program - described).isEmpty(),
                 qPrintable("not in the manual: " + listed(program - described)));
        QVERIFY2((described - program).isEmpty(),
                 qPrintable("not in the program: " + listed(described - program)));
    }
    void namesEveryCommandAtItsBeginning()
    {
        const QString beginning = manual().section("\n## ", 0, 0);
        for (const QString& command : helps().keys())
            QVERIFY2(beginning.contains(command == "window" ? QStringLiteral("agv-console [options]")
                                                            : "agv-console " + command + " "),
                     qPrintable(command));
    }
    void anOptionOfOneLetterIsShownAsItIsWritten()
    {
        QVERIFY(helps()["simulate"].contains("\n  --x <MM>"));
        QVERIFY(!helps()["simulate"].contains("\n  -x "));
    }
    void itsExamplesPrintWhatItSays_data()
    {
        QTest::addColumn<QString>("block");
        for (const QString& block : manual().split("```")) {
            // Those that go on for ever or turn an AGV for a minute are tested elsewhere.
            const bool isQuick =
                !block.contains("calibrate") && !block.contains("&\n") && !block.contains(" #");
            if (block.startsWith("\n$ ") && isQuick)
                QTest::newRow(qPrintable(block.section('\n', 1, 1))) << block.mid(1);
        }
    }
    void itsExamplesPrintWhatItSays()
    {
        QFETCH(QString, block);
        for (const QString& step : QString('\n' + block).split("\n$ ", Qt::SkipEmptyParts)) {
            if (step.startsWith("zcat")) // a file of the reader's own
                continue;
            QProcess shell;
            shell.setWorkingDirectory(m_folder.path());
            shell.setProcessEnvironment(m_environment);
            shell.setProcessChannelMode(QProcess::MergedChannels);
            shell.start("/bin/sh", {"-c", step.section('\n', 0, 0)});
            QVERIFY(shell.waitForFinished(60'000));
            const QStringList output = linesOf(QString::fromUtf8(shell.readAll()));
            const QStringList expected = linesOf(step.section('\n', 1));
            QVERIFY2(output.size() == expected.size(), qPrintable(output.join('\n')));
            for (qsizetype i = 0; i < output.size(); ++i)
                QVERIFY2(fits(output[i], expected[i]),
                         qPrintable(output[i] + "\n  instead of\n" + expected[i]));
        }
    }
    void initTestCase()
    {
        for (const QString folder : {"tests", "resources"})
            QVERIFY(QFile::link(AGV_SOURCE_DIR "/" + folder, m_folder.filePath(folder)));
        m_environment.insert("PATH", QFileInfo(AGV_PROGRAM).path() + ":" + m_environment.value("PATH"));
    }

private:
    static QStringList linesOf(const QString& text)
    {
        return text.split(QRegularExpression("\r?\n"), Qt::SkipEmptyParts);
    }

    QTemporaryDir m_folder;
    QProcessEnvironment m_environment = QProcessEnvironment::systemEnvironment();
};

} // namespace agv::app

QTEST_GUILESS_MAIN(agv::app::ManualTest)
#include "test_manual.moc"
