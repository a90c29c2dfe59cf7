// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/plot/curve_plot.h"
#include "gui/plot_panel.h"
#include "gui/uwb_fixture.h"
#include "model/statistics_table_model.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QPushButton>
#include <QTableView>
#include <QTabWidget>
#include <QToolButton>

using namespace agv;
using namespace agv::gui;
using model::PlotGroup;
using model::StatisticsTableModel;

class PlotPanelTest : public UwbFixture {
    Q_OBJECT

protected:
    void prepare() override;

private slots:
    void everyGroupCanBeShown();
    void theStatisticsAreThoseOfWhatIsVisible();
    void pauseHoldsThePictureAndTheDataGoOn();
    void choosingARangeEndsFollowing();
    void anErrorNeedsAReferenceAndSaysSo();
    void theDistributionMarksTheCircularErrors();
    void theVisibleValuesAreExported();
    void thePictureIsExportedAs_data();
    void thePictureIsExportedAs();
    void anExportThatFailsIsSaid();

private:
    PlotPanel* panel() const { return find<PlotPanel>("plots"); }
    CurvePlot* plot() const { return find<CurvePlot>("timePlot"); }
    QString statistic(int row, int column) const
    {
        return find<HintTableView>("statisticsTable")->model()->index(row, column).data().toString();
    }
    /// Ten seconds more, in which AGV 1 moves by 1 mm a snapshot.
    void drive()
    {
        for (int i = 0; i < 100; ++i) {
            m_snapshot.time += std::chrono::milliseconds(100);
            m_snapshot.agvs[0].pose->position.x += 0.001;
            m_window->showSnapshot(m_snapshot);
        }
    }

    PlantSnapshot m_snapshot;
};

void PlotPanelTest::prepare()
{
    openRunning();
    m_snapshot = scenes::uwbRunning();
    m_snapshot.agvs[0].pose = Pose2{{1.0, 2.0}, 0.0};
    raise("plotsDock");
    drive();
}

void PlotPanelTest::everyGroupCanBeShown()
{
    auto* groups = find<QComboBox>("groupCombo");
    QCOMPARE(groups->count(), model::plotGroupCount);
    const QImage before = plot()->grab().toImage();
    for (int i = 1; i < groups->count(); ++i) {
        groups->setCurrentIndex(i);
        QVERIFY(plot()->accessibleName().contains(groups->itemText(i)));
        m_window->showSnapshot(m_snapshot);
    }
    QVERIFY(plot()->grab().toImage() != before);
}

void PlotPanelTest::theStatisticsAreThoseOfWhatIsVisible()
{
    panel()->setSubject(1);
    const double now = panel()->feed().now_s();
    panel()->showRange(now - 1.0, now);
    QCOMPARE(statistic(0, StatisticsTableModel::Count), QStringLiteral("11"));
    panel()->showRange(now - 2.0, now);
    QCOMPARE(statistic(0, StatisticsTableModel::Count), QStringLiteral("21"));
}

void PlotPanelTest::pauseHoldsThePictureAndTheDataGoOn()
{
    find<QToolButton>("pauseButton")->setChecked(true);
    const double end = plot()->xTo();
    const double before = panel()->feed().now_s();
    drive();
    QCOMPARE(plot()->xTo(), end);
    QVERIFY(panel()->feed().now_s() > before + 9.0);
    find<QToolButton>("pauseButton")->setChecked(false);
    QCOMPARE(plot()->xTo(), panel()->feed().now_s());
}

void PlotPanelTest::choosingARangeEndsFollowing()
{
    emit plot() -> xRangeChosen(2.0, 4.0);
    QVERIFY(!find<QToolButton>("followButton")->isChecked());
    drive();
    QCOMPARE(plot()->xFrom(), 2.0);
    QCOMPARE(plot()->xTo(), 4.0);
    find<QToolButton>("followButton")->setChecked(true);
    QCOMPARE(plot()->xTo(), panel()->feed().now_s());
}

void PlotPanelTest::anErrorNeedsAReferenceAndSaysSo()
{
    QVERIFY(!find<QWidget>("referenceRow")->isVisible());
    panel()->setGroup(PlotGroup::PositionError);
    QVERIFY(find<QWidget>("referenceRow")->isVisible());
    QVERIFY(find<HintTableView>("statisticsTable")->model()->rowCount() == 0);
    panel()->setSubject(1);
    find<QDoubleSpinBox>("xSpin")->setValue(1100.0);
    find<QDoubleSpinBox>("ySpin")->setValue(2000.0);
    click("setReferenceButton");
    drive();
    QCOMPARE(statistic(0, StatisticsTableModel::Name), QStringLiteral("AGV 1"));
    const auto& errors = panel()->feed().series().at({PlotGroup::PositionError, 1, 0});
    QVERIFY(std::abs(errors.back().value - 100.0) < 0.01);
    click("takePoseButton");
    QCOMPARE(find<QDoubleSpinBox>("xSpin")->value(), 1200.0);
}

void PlotPanelTest::theDistributionMarksTheCircularErrors()
{
    const QImage before = find<CurvePlot>("cdfPlot")->grab().toImage();
    find<QTabWidget>("plotTabs")->setCurrentIndex(1);
    drive();
    QVERIFY(find<CurvePlot>("cdfPlot")->isVisible());
    QVERIFY(find<CurvePlot>("cdfPlot")->grab().toImage() != before);
}

void PlotPanelTest::theVisibleValuesAreExported()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("values.csv"));
    panel()->setSubject(1);
    const double now = panel()->feed().now_s();
    panel()->showRange(now - 1.0, now);
    panel()->exportTo(path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().split('\n');
    QCOMPARE(lines.first(), QByteArray("t_s,t_utc,agv1_x_mm,agv1_y_mm\r"));
    QCOMPARE(lines.size(), 1 + 11 + 1);
}

void PlotPanelTest::thePictureIsExportedAs_data()
{
    QTest::addColumn<QString>("ending");
    QTest::addColumn<QByteArray>("beginning");
    QTest::newRow("png") << "png" << QByteArray("\x89PNG");
    QTest::newRow("svg") << "svg" << QByteArray("<?xml");
    QTest::newRow("pdf") << "pdf" << QByteArray("%PDF");
}

void PlotPanelTest::thePictureIsExportedAs()
{
    QFETCH(QString, ending);
    QFETCH(QByteArray, beginning);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plot.") + ending);
    QList<bool> good;
    connect(panel(), &PlotPanel::exported, this, [&good](bool saved) { good << saved; });
    panel()->exportTo(path);
    QCOMPARE(good, QList<bool>{true});
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().startsWith(beginning));
    QVERIFY(file.size() > 2000);
}

void PlotPanelTest::anExportThatFailsIsSaid()
{
    QStringList sentences;
    connect(panel(), &PlotPanel::exported, this, [&](bool saved, const QString& sentence) {
        QVERIFY(!saved);
        sentences << sentence;
    });
    panel()->exportTo(QStringLiteral("/no/such/folder/values.csv"));
    panel()->exportTo(QStringLiteral("/no/such/folder/plot.png"));
    QCOMPARE(sentences.size(), 2);
    for (const QString& sentence : sentences)
        QVERIFY2(sentence.contains(QStringLiteral("/no/such/folder/")), qPrintable(sentence));
}

QTEST_MAIN(PlotPanelTest)
#include "test_plot_panel.moc"
