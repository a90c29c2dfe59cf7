// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/cell_input.h"

#include <QLocale>

#include <cmath>

namespace agv::model {
namespace {

std::optional<double> parsed(QString text)
{
    text = text.trimmed().replace(QChar(0x2212), QLatin1Char('-'));
    bool good = false;
    double value = QLocale().toDouble(text, &good);
    if (!good)
        value = QLocale::c().toDouble(text, &good);
    return good && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

Result<double> CellInput::number(const QString& text, const QString& field, double least, double most)
{
    const std::optional<double> value = parsed(text);
    if (!value) {
        return failure(ErrorCode::BadInput,
                       tr("\"%1\" is not a number: %2 stays as it was.").arg(text, field).toStdString());
    }
    if (*value < least || *value > most) {
        return failure(ErrorCode::BadInput, tr("\"%1\" is out of range: %2 may be from %3 to %4.")
                                                .arg(text, field, shown(least, 0), shown(most, 0))
                                                .toStdString());
    }
    return *value;
}

Result<int> CellInput::wholeNumber(const QString& text, const QString& field, int least, int most)
{
    const Result<double> value = number(text, field, least, most);
    if (!value)
        return std::unexpected(value.error());
    if (std::trunc(*value) != *value) {
        return failure(
            ErrorCode::BadInput,
            tr("\"%1\" is not a whole number: %2 stays as it was.").arg(text, field).toStdString());
    }
    return static_cast<int>(*value);
}

QString CellInput::editable(double value)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double rounded = std::round(value * 1e6) / 1e6;
    return locale.toString(rounded == 0.0 ? 0.0 : rounded, 'g', QLocale::FloatingPointShortest);
}

QString CellInput::shown(double value, int decimals)
{
    const double scale = std::pow(10.0, decimals);
    const double rounded = std::round(value * scale) / scale;
    QString text = QLocale().toString(rounded == 0.0 ? 0.0 : rounded, 'f', decimals);
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

QString CellInput::shown(std::optional<double> value, int decimals)
{
    return value ? shown(*value, decimals) : none();
}

const QString& CellInput::none()
{
    static const QString dash(QChar(0x2013));
    return dash;
}

} // namespace agv::model
