// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace agv::app {

/// Why a command line is not carried out: help, version, or a usage error.
struct ParseExit {
    int status = 0; ///< 0: text goes to standard output; 2: usage error, text goes to standard error
    QString text;
};

/// The options of one subcommand, with the manners of Unix: an error names the option and its range, and
/// never ends the program by itself.
class OptionReader {
public:
    /// `command`: as typed, e.g. "agv-console calibrate".
    OptionReader(QString command, const QString& description);

    void addFlag(const QString& name, const QString& description);
    void addValue(const QString& name, const QString& valueName, const QString& description);
    /// Options end at the first positional argument: what follows may begin with a minus.
    void keepWhatFollows();
    void addPositional(const QString& name, const QString& description, const QString& syntax);

    /// `arguments` without the program and the subcommand. Empty: go on. Must be called once, before the
    /// rest.
    std::optional<ParseExit> parse(const QStringList& arguments);

    bool isSet(const QString& name) const { return m_parser.isSet(name); }
    QStringList positional() const { return m_parser.positionalArguments(); }
    std::optional<QString> text(const QString& name) const;
    // Each notes the first error for error(); nothing when the option is not set or wrong.
    std::optional<double> number(const QString& name, double lowest, double highest);
    std::optional<std::uint64_t> integer(const QString& name, std::uint64_t lowest, std::uint64_t highest);
    std::optional<QString> choice(const QString& name, const QStringList& allowed);
    void require(bool fulfilled, const QString& complaint);
    void forbidPositional();

    /// The first error of the calls above.
    std::optional<ParseExit> error() const { return m_error; }

private:
    void complain(const QString& text);

    QString m_command;
    QCommandLineParser m_parser;
    std::optional<ParseExit> m_error;
};

} // namespace agv::app
