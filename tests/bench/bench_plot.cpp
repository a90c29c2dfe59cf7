// SPDX-License-Identifier: GPL-3.0-or-later
// Milliseconds per frame of a plot with ten curves at 1600 x 800, from the points to the painted widget:
// scrolling, panning and zooming.
#include "bench/frame_times.h"
#include "core/random.h"
#include "gui/plot/curve_plot.h"
#include "model/time_series.h"

#include <QApplication>
#include <QImage>

#include <cmath>
#include <string>
#include <vector>

namespace {

using agv::model::SeriesPoint;
using agv::model::TimeSeries;

constexpr int curves = 10;

std::vector<TimeSeries> walks(std::size_t points)
{
    std::vector<TimeSeries> all(curves, TimeSeries(points + 1));
    agv::SplitMix64 random(1);
    for (TimeSeries& series : all) {
        double value = 0.0;
        for (std::size_t i = 0; i < points; ++i)
            series.append(0.01 * static_cast<double>(i), value += random.normal());
    }
    return all;
}

class Picture {
public:
    explicit Picture(std::size_t points) : m_series(walks(points)), m_end(m_series[0].back().t)
    {
        m_plot.resize(1600, 800);
        m_plot.setTheme(agv::gui::Theme::light());
        QStringList names;
        for (int i = 0; i < curves; ++i)
            names << QString::number(i);
        m_plot.setCurves(names);
        m_plot.show();
        m_screen = QImage(m_plot.size(), QImage::Format_RGB32);
    }
    double end() const { return m_end; }
    void draw(double from, double to)
    {
        m_plot.setXRange(from, to);
        for (int i = 0; i < curves; ++i) {
            m_series[static_cast<std::size_t>(i)].envelope(
                from, to, static_cast<std::size_t>(m_plot.plotWidth()), m_points);
            m_plot.setPoints(i, m_points);
        }
        m_plot.fitY(false);
        m_plot.replot();
        QCoreApplication::processEvents(); // the queued replot
        m_plot.render(&m_screen);
    }

private:
    std::vector<TimeSeries> m_series;
    double m_end;
    agv::gui::CurvePlot m_plot;
    std::vector<SeriesPoint> m_points;
    QImage m_screen;
};

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    for (const std::size_t points : {std::size_t{100'000}, std::size_t{1'000'000}}) {
        Picture picture(points);
        const std::string size = "10 x " + std::to_string(points) + ", ";
        const double end = picture.end();
        agv::bench::reportFrames((size + "everything, scrolling").c_str(), 200,
                                 [&](int i) { picture.draw(0.01 * i, end + 0.01 * i); });
        agv::bench::reportFrames((size + "a tenth, panning").c_str(), 200, [&](int i) {
            const double from = 0.9 * end * i / 200.0;
            picture.draw(from, from + 0.1 * end);
        });
        agv::bench::reportFrames((size + "zooming in and out").c_str(), 200, [&](int i) {
            const double half = 0.5 * end * std::pow(0.93, i < 100 ? i : 200 - i);
            picture.draw(0.5 * end - half, 0.5 * end + half);
        });
    }
    return 0;
}
