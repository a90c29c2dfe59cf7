// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/plot_panel.h"

#include "gui/hint_table_view.h"
#include "gui/picture_file.h"
#include "gui/plot/bar_chart.h"
#include "gui/plot/curve_plot.h"
#include "model/messages.h"
#include "model/plot_csv.h"
#include "ui_plot_panel.h"

#include "core/text_file.h"

#include <QEvent>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace agv::gui {

using model::PlotFeed;
using model::PlotGroup;
using model::SeriesKey;

namespace {

constexpr double statisticsEvery_s = 0.5;
constexpr double wholeSession_s = 1e9;
constexpr std::size_t histogramClasses = 12;

/// In the order of the list.
constexpr PlotGroup listedGroups[] = {
    PlotGroup::Position,    PlotGroup::Heading, PlotGroup::PositionError, PlotGroup::HeadingError,
    PlotGroup::Uncertainty, PlotGroup::Ranges,  PlotGroup::Residuals,     PlotGroup::Signal,
    PlotGroup::WheelSpeeds, PlotGroup::Charge,  PlotGroup::Voltage,       PlotGroup::Rates,
    PlotGroup::Ages,
};

} // namespace

PlotPanel::PlotPanel(QWidget* parent) : QWidget(parent), m_ui(std::make_unique<Ui::PlotPanel>())
{
    m_ui->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    fillGroups();
    fillSpans();
    m_ui->cdfPlot->keepLegendSmall();
    m_ui->statisticsTable->setModel(&m_statistics);
    m_ui->statisticsTable->verticalHeader()->hide();
    m_ui->statisticsTable->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    connect(m_ui->groupCombo, &QComboBox::currentIndexChanged, this, &PlotPanel::onGroupChanged);
    connect(m_ui->subjectCombo, &QComboBox::currentIndexChanged, this, &PlotPanel::redraw);
    connect(m_ui->spanCombo, &QComboBox::currentIndexChanged, this, [this] { setFollowing(true); });
    connect(m_ui->followButton, &QToolButton::toggled, this, &PlotPanel::redraw);
    connect(m_ui->pauseButton, &QToolButton::toggled, this, &PlotPanel::redraw);
    connect(m_ui->exportButton, &QToolButton::clicked, this, &PlotPanel::askForFile);
    connect(m_ui->plotTabs, &QTabWidget::currentChanged, this, &PlotPanel::redraw);
    connect(m_ui->setReferenceButton, &QPushButton::clicked, this, &PlotPanel::useReference);
    connect(m_ui->takePoseButton, &QPushButton::clicked, this, &PlotPanel::takePose);
    connect(m_ui->timePlot, &CurvePlot::xRangeChosen, this, &PlotPanel::onRangeChosen);
    connect(m_ui->timePlot, &CurvePlot::cursorMoved, this, [this](std::optional<double> t) {
        m_cursor = t;
        updateStatistics();
    });
    onGroupChanged();
}

PlotPanel::~PlotPanel() = default;

void PlotPanel::fillGroups()
{
    const int chosen = std::max(0, m_ui->groupCombo->currentIndex());
    const QSignalBlocker quiet(m_ui->groupCombo);
    m_ui->groupCombo->clear();
    for (const PlotGroup each : listedGroups)
        m_ui->groupCombo->addItem(PlotFeed::name(each), static_cast<int>(each));
    m_ui->groupCombo->setCurrentIndex(chosen);
}

void PlotPanel::fillSpans()
{
    const int chosen = m_ui->spanCombo->count() > 0 ? m_ui->spanCombo->currentIndex() : 1;
    const QSignalBlocker quiet(m_ui->spanCombo);
    m_ui->spanCombo->clear();
    m_ui->spanCombo->addItem(tr("30 seconds"), 30.0);
    m_ui->spanCombo->addItem(tr("2 minutes"), 120.0);
    m_ui->spanCombo->addItem(tr("10 minutes"), 600.0);
    m_ui->spanCombo->addItem(tr("1 hour"), 3600.0);
    m_ui->spanCombo->addItem(tr("Everything"), wholeSession_s);
    m_ui->spanCombo->setCurrentIndex(chosen);
}

PlotGroup PlotPanel::group() const { return static_cast<PlotGroup>(m_ui->groupCombo->currentData().toInt()); }

bool PlotPanel::isError() const
{
    return group() == PlotGroup::PositionError || group() == PlotGroup::HeadingError;
}

void PlotPanel::setGroup(PlotGroup group)
{
    m_ui->groupCombo->setCurrentIndex(m_ui->groupCombo->findData(static_cast<int>(group)));
}

void PlotPanel::setSubject(std::optional<int> subject)
{
    m_ui->subjectCombo->setCurrentIndex(subject ? m_ui->subjectCombo->findData(*subject) : 0);
}

void PlotPanel::setTheme(const Theme& theme)
{
    m_ui->timePlot->setTheme(theme);
    m_ui->cdfPlot->setTheme(theme);
    m_ui->histogram->setTheme(theme);
}

void PlotPanel::showSnapshot(const PlantSnapshot& snapshot)
{
    m_feed.add(snapshot);
    if (!isVisible() || m_ui->pauseButton->isChecked())
        return;
    updateSubjects();
    drawCurves();
    if (m_feed.now_s() - m_statisticsAt_s >= statisticsEvery_s) {
        updateStatistics();
        drawDistribution();
    }
}

void PlotPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    redraw();
}

void PlotPanel::updateSubjects()
{
    // For errors all AGVs are offered: the reference of one is what its curve needs.
    const std::vector<int> subjects = m_feed.subjectsOf(isError() ? PlotGroup::Rates : group());
    bool isSame = static_cast<std::size_t>(m_ui->subjectCombo->count()) == subjects.size() + 1;
    for (std::size_t i = 0; isSame && i < subjects.size(); ++i)
        isSame = m_ui->subjectCombo->itemData(static_cast<int>(i) + 1).toInt() == subjects[i];
    if (isSame)
        return;
    const QVariant chosen = m_ui->subjectCombo->currentData();
    const QSignalBlocker quiet(m_ui->subjectCombo);
    m_ui->subjectCombo->clear();
    m_ui->subjectCombo->addItem(PlotFeed::isOfTag(group()) ? tr("All tags") : tr("All AGVs"));
    for (const int subject : subjects)
        m_ui->subjectCombo->addItem(
            PlotFeed::isOfTag(group()) ? tr("Tag %1").arg(subject) : tr("AGV %1").arg(subject), subject);
    m_ui->subjectCombo->setCurrentIndex(chosen.isValid() ? std::max(0, m_ui->subjectCombo->findData(chosen))
                                                         : 0);
}

void PlotPanel::onGroupChanged()
{
    m_ui->referenceRow->setVisible(isError());
    m_ui->timePlot->setAxisTitles(
        tr("Time since the start, s"),
        QStringLiteral("%1, %2").arg(PlotFeed::name(group()), PlotFeed::unit(group())));
    m_ui->cdfPlot->setAxisTitles(
        QStringLiteral("|%1|, %2").arg(PlotFeed::name(group()), PlotFeed::unit(group())),
        tr("Share that is not larger, %"));
    updateSubjects();
    redraw();
}

void PlotPanel::setFollowing(bool following)
{
    m_ui->followButton->setChecked(following);
    redraw();
}

void PlotPanel::onRangeChosen(double from, double to) { showRange(from, to); }

void PlotPanel::showRange(double from, double to)
{
    const QSignalBlocker quiet(m_ui->followButton);
    m_ui->followButton->setChecked(false);
    m_ui->timePlot->setXRange(from, to);
    redraw();
}

void PlotPanel::follow()
{
    const double span = std::min(m_ui->spanCombo->currentData().toDouble(), std::max(10.0, m_feed.now_s()));
    m_ui->timePlot->setXRange(m_feed.now_s() - span, m_feed.now_s());
}

void PlotPanel::redraw()
{
    updateSubjects();
    drawCurves();
    updateStatistics();
    drawDistribution();
}

QString PlotPanel::hint() const
{
    if (isError())
        return tr("Type where the AGV truly is, choose the AGV above, and press Use.");
    switch (group()) {
    case PlotGroup::Position:
    case PlotGroup::Heading:
    case PlotGroup::Uncertainty:
        return tr("No position yet: calibrate an AGV.");
    case PlotGroup::Ranges:
    case PlotGroup::Residuals:
        return tr("No UWB ranges yet: open the UWB unit and switch a tag on.");
    default:
        return tr("Nothing yet: connect an AGV.");
    }
}

void PlotPanel::drawCurves()
{
    if (m_ui->followButton->isChecked() && !m_ui->pauseButton->isChecked())
        follow();
    const QVariant subject = m_ui->subjectCombo->currentData();
    std::vector<SeriesKey> keys =
        m_feed.keysOf(group(), subject.isValid() ? std::optional(subject.toInt()) : std::nullopt);
    if (keys != m_keys) {
        m_keys = std::move(keys);
        QStringList names;
        for (const SeriesKey& key : m_keys)
            names << PlotFeed::name(key);
        m_ui->timePlot->setCurves(names);
        m_ui->cdfPlot->setCurves(names);
    }
    m_ui->timePlot->setHint(hint());
    const auto buckets = static_cast<std::size_t>(m_ui->timePlot->plotWidth());
    for (std::size_t i = 0; i < m_keys.size(); ++i) {
        m_feed.series().at(m_keys[i]).envelope(m_ui->timePlot->xFrom(), m_ui->timePlot->xTo(), buckets,
                                               m_scratch);
        m_ui->timePlot->setPoints(static_cast<int>(i), m_scratch);
    }
    m_ui->timePlot->fitY(group() == PlotGroup::PositionError || group() == PlotGroup::Uncertainty);
    m_ui->timePlot->replot();
}

void PlotPanel::updateStatistics()
{
    m_statisticsAt_s = m_feed.now_s();
    std::vector<model::StatisticsTableModel::Row> rows;
    for (const SeriesKey& key : m_keys) {
        const model::TimeSeries& series = m_feed.series().at(key);
        model::StatisticsTableModel::Row row;
        row.name = PlotFeed::name(key);
        row.statistics = model::statisticsOf(series, m_ui->timePlot->xFrom(), m_ui->timePlot->xTo());
        if (m_cursor) {
            series.range(*m_cursor - model::usualGap_s, *m_cursor, m_scratch);
            if (!m_scratch.empty())
                row.atCursor = m_scratch.back().value;
        }
        rows.push_back(std::move(row));
    }
    m_statistics.setRows(rows, PlotFeed::unit(group()));
    m_ui->statisticsTable->setHint(tr("Statistics of the visible part of the curves."));
}

void PlotPanel::drawDistribution()
{
    if (m_ui->plotTabs->currentWidget() != m_ui->distributionTab)
        return;
    const double from = m_ui->timePlot->xFrom();
    const double to = m_ui->timePlot->xTo();
    double largest = 1e-9;
    for (std::size_t i = 0; i < m_keys.size(); ++i) {
        std::vector<model::SeriesPoint> points =
            model::distributionOf(m_feed.series().at(m_keys[i]), from, to);
        for (model::SeriesPoint& point : points)
            point.value *= 100.0;
        if (!points.empty())
            largest = std::max(largest, points.back().t);
        m_ui->cdfPlot->setPoints(static_cast<int>(i), points);
    }
    m_ui->cdfPlot->setXRange(0.0, 1.05 * largest);
    m_ui->cdfPlot->fitY(true);
    m_ui->cdfPlot->setHint(hint());
    std::vector<std::pair<double, QString>> marks;
    QStringList categories;
    std::vector<double> counts;
    if (!m_keys.empty()) {
        const model::TimeSeries& first = m_feed.series().at(m_keys.front());
        const QString unit = PlotFeed::unit(group());
        if (const auto s = model::statisticsOf(first, from, to)) {
            const QLocale locale;
            for (const auto& [name, value] :
                 {std::pair("CE50", s->p50), std::pair("CE75", s->p75), std::pair("CE95", s->p95)})
                marks.emplace_back(value,
                                   QStringLiteral("%1 %2 %3")
                                       .arg(QString::fromLatin1(name), locale.toString(value, 'f', 1), unit));
        }
        const model::Histogram histogram = model::histogramOf(first, from, to, histogramClasses);
        counts = histogram.counts;
        for (std::size_t i = 0; i < counts.size(); ++i)
            categories << QLocale().toString(histogram.lowest +
                                                 (static_cast<double>(i) + 0.5) * histogram.width,
                                             'f', histogram.width < 1.0 ? 1 : 0);
    }
    m_ui->cdfPlot->setMarks(marks);
    m_ui->cdfPlot->replot();
    m_ui->histogram->setAxisTitles(
        QStringLiteral("%1, %2").arg(PlotFeed::name(group()), PlotFeed::unit(group())), tr("Values"));
    m_ui->histogram->setData(categories,
                             {{m_keys.empty() ? QString() : PlotFeed::name(m_keys.front()), counts,
                               palette().color(QPalette::Mid), palette().color(QPalette::Dark)}});
}

void PlotPanel::useReference()
{
    const QVariant subject = m_ui->subjectCombo->currentData();
    const std::vector<int> robots = m_feed.subjectsOf(PlotGroup::Rates);
    const Pose2 truth{{1e-3 * m_ui->xSpin->value(), 1e-3 * m_ui->ySpin->value()},
                      radFromDeg(m_ui->headingSpin->value())};
    if (subject.isValid())
        m_feed.setReference(subject.toInt(), truth);
    else if (robots.size() == 1)
        m_feed.setReference(robots.front(), truth);
    else
        m_ui->subjectCombo->showPopup(); // of which AGV?
    redraw();
}

void PlotPanel::takePose()
{
    const QVariant subject = m_ui->subjectCombo->currentData();
    if (!subject.isValid())
        return m_ui->subjectCombo->showPopup();
    const std::optional<Pose2> pose = m_feed.pose(subject.toInt());
    if (!pose)
        return;
    m_ui->xSpin->setValue(1e3 * pose->position.x);
    m_ui->ySpin->setValue(1e3 * pose->position.y);
    m_ui->headingSpin->setValue(degFromRad(pose->heading));
}

void PlotPanel::askForFile()
{
    // Qt's own dialog, not modal: Stop all stays in reach.
    auto* dialog = new QFileDialog(this, tr("Export the plot"));
    dialog->setObjectName(QStringLiteral("plotExportDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(pictureFilters() << tr("Visible values (*.csv)"));
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(QLatin1Char('.'), -1).chopped(1));
    });
    connect(dialog, &QFileDialog::fileSelected, this, &PlotPanel::exportTo);
    dialog->show();
}

void PlotPanel::exportTo(const QString& path)
{
    Result<void> saved;
    if (path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)) {
        saved = writeTextFile(QFile::encodeName(path).toStdString(),
                              plotCsv(m_feed, m_keys, m_ui->timePlot->xFrom(), m_ui->timePlot->xTo()));
    } else {
        const CurvePlot* plot =
            m_ui->plotTabs->currentWidget() == m_ui->timeTab ? m_ui->timePlot : m_ui->cdfPlot;
        saved = savePicture(path, plot->size(),
                            [plot](QPainter& painter) { plot->paint(painter, plot->size()); });
    }
    emit exported(saved.has_value(), saved ? tr("The plot was saved as %1").arg(path)
                                           : model::Messages::sentence(saved.error().detail));
}

void PlotPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        fillGroups();
        fillSpans();
        m_ui->subjectCombo->clear();
        m_keys.clear();
        onGroupChanged();
    }
    QWidget::changeEvent(event);
}

} // namespace agv::gui
