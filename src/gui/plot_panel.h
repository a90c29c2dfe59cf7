// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/snapshot.h"
#include "gui/theme.h"
#include "model/plot_feed.h"
#include "model/statistics_table_model.h"

#include <memory>
#include <optional>
#include <vector>

namespace Ui {
class PlotPanel;
}

namespace agv::gui {

/// Curves of the session over time, their statistics and distribution, and what can be exported of them.
/// Collects always, paints only while it is to be seen. GUI thread.
class PlotPanel : public QWidget {
    Q_OBJECT
public:
    explicit PlotPanel(QWidget* parent = nullptr);
    ~PlotPanel() override;

    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);

    const model::PlotFeed& feed() const { return m_feed; }
    void setGroup(model::PlotGroup group);
    /// Of the curves; nullopt: all.
    void setSubject(std::optional<int> subject);
    /// The visible part of the time, s.
    void showRange(double from, double to);
    /// .png, .svg, .pdf or .csv, by the name's ending.
    void exportTo(const QString& path);

signals:
    /// A sentence for the event log; in the language of the program.
    void exported(bool good, const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    QSize sizeHint() const override { return {700, 320}; }

private:
    void fillGroups();
    void fillSpans();
    void updateSubjects();
    void onGroupChanged();
    void onRangeChosen(double from, double to);
    void setFollowing(bool following);
    void follow();
    void redraw();
    void drawCurves();
    void updateStatistics();
    void drawDistribution();
    void useReference();
    void takePose();
    void askForFile();
    QString hint() const;
    model::PlotGroup group() const;
    bool isError() const;

    std::unique_ptr<Ui::PlotPanel> m_ui;
    model::PlotFeed m_feed;
    model::StatisticsTableModel m_statistics;
    std::vector<model::SeriesKey> m_keys; ///< of the curves shown
    std::vector<model::SeriesPoint> m_scratch;
    std::optional<double> m_cursor;
    double m_statisticsAt_s = -1e9; ///< they cost more than the picture and are made twice a second
};

} // namespace agv::gui
