// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/plot_csv.h"

#include <QDateTime>

#include <cmath>
#include <map>

namespace agv::model {

std::string plotCsv(const PlotFeed& feed, const std::vector<SeriesKey>& keys, double from, double to)
{
    QString text = QStringLiteral("t_s,t_utc");
    for (const SeriesKey& key : keys)
        text += QLatin1Char(',') + PlotFeed::columnName(key);
    text += QStringLiteral("\r\n");
    std::map<double, std::vector<QString>> rows;
    std::vector<SeriesPoint> points;
    for (std::size_t column = 0; column < keys.size(); ++column) {
        const auto found = feed.series().find(keys[column]);
        if (found == feed.series().end())
            continue;
        found->second.range(from, to, points);
        for (const SeriesPoint& point : points) {
            std::vector<QString>& row = rows[point.t];
            row.resize(keys.size());
            row[column] = QString::number(point.value, 'g', 10);
        }
    }
    for (const auto& [t, row] : rows) {
        const auto utc = QDateTime::fromMSecsSinceEpoch(feed.began_utc_ms() + std::llround(1e3 * t)).toUTC();
        text += QString::number(t, 'f', 3) + QLatin1Char(',') + utc.toString(Qt::ISODateWithMs);
        for (const QString& field : row)
            text += QLatin1Char(',') + field;
        text += QStringLiteral("\r\n");
    }
    return text.toStdString();
}

} // namespace agv::model
