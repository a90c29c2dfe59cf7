// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_reader.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <utility>

namespace agv::app {

OptionReader::OptionReader(QString command, const QString& description) : m_command(std::move(command))
{
    m_parser.setApplicationDescription(description);
    m_parser.addOption({{"h", "help"}, "Show this help and end."});
    m_parser.addOption({{"v", "version"}, "Show the version and end."});
}

void OptionReader::addFlag(const QString& name, const QString& description)
{
    m_parser.addOption({name, description});
}

void OptionReader::addValue(const QString& name, const QString& valueName, const QString& description)
{
    m_parser.addOption({name, description, valueName});
}

void OptionReader::addPositional(const QString& name, const QString& description, const QString& syntax)
{
    m_parser.addPositionalArgument(name, description, syntax);
}

void OptionReader::keepWhatFollows()
{
    m_parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsPositionalArguments);
}

std::optional<ParseExit> OptionReader::parse(const QStringList& arguments)
{
    const bool understood = m_parser.parse(QStringList(m_command) + arguments);
    if (m_parser.isSet("help")) {
        QString help = m_parser.helpText();
        // Qt names the program file; people type the command.
        help.replace("Usage: " + QCoreApplication::arguments().value(0), "Usage: " + m_command);
        // It would show --x as -x, unlike every other option and the manual.
        static const QRegularExpression oneLetter("^  -(\\w) (<\\w+>) ", QRegularExpression::MultilineOption);
        help.replace(oneLetter, "  --\\1 \\2");
        return ParseExit{0, help};
    }
    if (m_parser.isSet("version"))
        return ParseExit{0, QStringLiteral("agv-console " AGV_VERSION "\n")};
    if (!understood)
        complain(m_parser.errorText());
    return m_error;
}

std::optional<QString> OptionReader::text(const QString& name) const
{
    return isSet(name) ? std::optional(m_parser.value(name)) : std::nullopt;
}

std::optional<double> OptionReader::number(const QString& name, double lowest, double highest)
{
    const std::optional<QString> value = text(name);
    if (!value)
        return std::nullopt;
    bool valid = false;
    const double number = value->toDouble(&valid);
    if (valid && number >= lowest && number <= highest)
        return number;
    complain(QStringLiteral("--%1 is \"%2\": it must be a number from %3 to %4")
                 .arg(name, *value)
                 .arg(lowest)
                 .arg(highest));
    return std::nullopt;
}

std::optional<std::uint64_t> OptionReader::integer(const QString& name, std::uint64_t lowest,
                                                   std::uint64_t highest)
{
    const std::optional<QString> value = text(name);
    if (!value)
        return std::nullopt;
    bool valid = false;
    const std::uint64_t number = value->toULongLong(&valid);
    if (valid && number >= lowest && number <= highest)
        return number;
    complain(QStringLiteral("--%1 is \"%2\": it must be a whole number from %3 to %4")
                 .arg(name, *value)
                 .arg(lowest)
                 .arg(highest));
    return std::nullopt;
}

std::optional<QString> OptionReader::choice(const QString& name, const QStringList& allowed)
{
    const std::optional<QString> value = text(name);
    if (!value || allowed.contains(*value))
        return value;
    complain(QStringLiteral("--%1 is \"%2\": it must be one of %3").arg(name, *value, allowed.join(", ")));
    return std::nullopt;
}

void OptionReader::require(bool fulfilled, const QString& complaint)
{
    if (!fulfilled)
        complain(complaint);
}

void OptionReader::forbidPositional()
{
    if (!positional().isEmpty())
        complain(QStringLiteral("Unexpected argument \"%1\"").arg(positional().constFirst()));
}

void OptionReader::complain(const QString& text)
{
    if (m_error)
        return;
    const QString sentence = text.endsWith('.') ? text.chopped(1) : text;
    m_error = ParseExit{2, m_command + ": " + sentence + ".\nTry \"" + m_command + " --help\".\n"};
}

} // namespace agv::app
