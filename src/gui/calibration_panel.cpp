// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/calibration_panel.h"

#include "gui/cell_delegates.h"
#include "gui/glyphs.h"
#include "gui/result_card.h"
#include "gui/result_text.h"
#include "model/messages.h"
#include "model/words.h"
#include "ui_calibration_panel.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QSignalBlocker>

#include <cmath>
#include <utility>

namespace agv::gui {

using model::Words;

namespace {

int stopsOf(int comboIndex) { return 8 + 4 * comboIndex; }

/// As the fields show them: ms of s, mm/s of m/s.
int inThousandths(double value) { return static_cast<int>(std::lround(value * 1e3)); }

QString reasonOf(const LinkSnapshot& link)
{
    return link.reason.empty() ? Words::linkState(link.state) : model::Messages::sentence(link.reason);
}

} // namespace

CalibrationPanel::CalibrationPanel(QWidget* parent)
    : QWidget(parent),
      m_ui(std::make_unique<Ui::CalibrationPanel>())
{
    m_ui->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    m_ui->initialiseButton->setProperty("primary", true);
    m_ui->sleeptimeSpin->setRange(leastSleeptime_ms, mostSleeptime_ms);
    m_ui->wheelSpeedSpin->setRange(inThousandths(leastTurnSpeed), inThousandths(mostTurnSpeed));
    m_ui->dwellSpin->setRange(inThousandths(TurnParameters().minDwell_s), inThousandths(mostDwell_s));
    m_ui->dwellSpin->setValue(inThousandths(TurnParameters().maxDwell_s));
    m_ui->previewLabel->hide();
    m_ui->stopTable->setModel(&m_stops);
    m_ui->stopTable->setItemDelegate(
        new WarningDelegate(model::StopTableModel::WarningRole, m_ui->stopTable));
    m_ui->stopTable->setSelectionMode(QAbstractItemView::SingleSelection);
    m_ui->stopTable->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_ui->stopTable->setMinimumHeight(140);
    connectWidgets();
    retranslate();
    updateActions();
}

CalibrationPanel::~CalibrationPanel() = default;

void CalibrationPanel::connectWidgets()
{
    connect(m_ui->robotCombo, &QComboBox::currentIndexChanged, this, [this] {
        showRobot();
        emit robotChosen(robot());
    });
    connect(m_ui->initialiseButton, &QPushButton::clicked, this, &CalibrationPanel::initialise);
    connect(m_ui->abortButton, &QPushButton::clicked, this, &CalibrationPanel::abort);
    connect(m_ui->resultCard, &ResultCard::turnTimeApplied, this, &CalibrationPanel::applyTurnTime);
    connect(m_ui->retakeButton, &QPushButton::clicked, this, &CalibrationPanel::retake);
    connect(m_ui->copyButton, &QPushButton::clicked, this, &CalibrationPanel::copyTable);
    connect(m_ui->sleeptimeSpin, &QSpinBox::editingFinished, this, &CalibrationPanel::sendTurnTime);
    connect(m_ui->wheelSpeedSpin, &QSpinBox::editingFinished, this, &CalibrationPanel::sendTurnSpeed);
    connect(m_ui->stopsCombo, &QComboBox::currentIndexChanged, this, &CalibrationPanel::showRobot);
    connect(m_ui->stopTable->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &CalibrationPanel::updateActions);
    connect(&m_stops, &QAbstractItemModel::modelReset, this, &CalibrationPanel::updateActions);
}

void CalibrationPanel::setPlant(const PlantLayout& plant)
{
    m_plant = plant;
    const QSignalBlocker blocker(m_ui->robotCombo);
    m_ui->robotCombo->clear();
    for (const AgvConfig& agv : plant.agvs) {
        const QString name =
            agv.name.empty() ? tr("AGV %1").arg(agv.id.number) : QString::fromStdString(agv.name);
        m_ui->robotCombo->addItem(name, agv.id.number);
    }
    if (!plant.agvs.empty()) {
        m_ui->sleeptimeSpin->setValue(inThousandths(plant.agvs.front().turnTime_s));
        showTurnSpeed(plant.agvs.front().turnSpeed_m_s);
    }
    updateActions();
}

void CalibrationPanel::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_ui->progress->setTheme(theme);
    static_cast<WarningDelegate*>(m_ui->stopTable->itemDelegate())->setTheme(theme);
    m_ui->fitPlot->setTheme(theme);
    m_ui->initialiseButton->setIcon(glyphIcon(Glyph::Turn, theme.accentText, theme.disabledText));
    m_ui->abortButton->setIcon(glyphIcon(Glyph::Abort, theme.text, theme.disabledText));
    m_ui->retakeButton->setIcon(glyphIcon(Glyph::Retake, theme.text, theme.disabledText));
    m_ui->copyButton->setIcon(glyphIcon(Glyph::Copy, theme.text, theme.disabledText));
    m_ui->resultCard->setTheme(theme);
    showRobot();
}

int CalibrationPanel::robot() const { return m_ui->robotCombo->currentData().toInt(); }

QString CalibrationPanel::robotName() const { return m_ui->robotCombo->currentText(); }

void CalibrationPanel::setRobot(int robot)
{
    const int index = m_ui->robotCombo->findData(robot);
    if (index >= 0)
        m_ui->robotCombo->setCurrentIndex(index);
}

TurnParameters CalibrationPanel::parameters() const
{
    TurnParameters p;
    p.kind = m_ui->kindCombo->currentIndex() == 0 ? TurnKind::Timed : TurnKind::Measured;
    p.rotation = m_ui->directionCombo->currentIndex() == 0 ? Rotation::CounterClockwise : Rotation::Clockwise;
    p.stopsPerTurn = stopsOf(m_ui->stopsCombo->currentIndex());
    p.turnTime_s = m_ui->sleeptimeSpin->value() * 1e-3;
    p.maxDwell_s = m_ui->dwellSpin->value() * 1e-3;
    p.adaptiveDwell = m_ui->adaptiveCheck->isChecked();
    p.wheelSpeed_m_s = m_ui->wheelSpeedSpin->value() * 1e-3;
    return p;
}

const AgvSnapshot* CalibrationPanel::current() const
{
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        if (agv.id.number == robot())
            return &agv;
    }
    return nullptr;
}

QString CalibrationPanel::nameOf(const AgvSnapshot& agv) const
{
    return agv.name.empty() ? tr("AGV %1").arg(agv.id.number) : QString::fromStdString(agv.name);
}

QString CalibrationPanel::obstacleToStart(const AgvSnapshot& agv) const
{
    if (agv.robotLink.state == LinkState::Failed)
        return tr("The robot of %1 cannot connect: %2.").arg(nameOf(agv), reasonOf(agv.robotLink));
    if (agv.robotLink.state != LinkState::Up)
        return tr("The robot of %1 is not connected. Switch it on; it connects by itself.").arg(nameOf(agv));
    if (agv.readerLink.state == LinkState::Down)
        return tr("The RFID reader of %1 is closed. Press Open RFID.").arg(nameOf(agv));
    if (agv.readerLink.state != LinkState::Up)
        return tr("The RFID reader of %1 does not deliver: %2.").arg(nameOf(agv), reasonOf(agv.readerLink));
    return {};
}

bool CalibrationPanel::canStart() const
{
    const AgvSnapshot* agv = current();
    return agv && !isRunning(agv->turn.phase) && obstacleToStart(*agv).isEmpty();
}

bool CalibrationPanel::canAbort() const
{
    const AgvSnapshot* agv = current();
    return agv && isRunning(agv->turn.phase);
}

void CalibrationPanel::initialise()
{
    if (!canStart())
        return;
    sendTurnSpeed();
    sendTurnTime();
    emit startTurnRequested(robot(), parameters());
}

void CalibrationPanel::abort()
{
    if (canAbort())
        emit abortTurnRequested(robot());
}

void CalibrationPanel::sendTurnTime()
{
    const AgvSnapshot* agv = current();
    const int typed_ms = m_ui->sleeptimeSpin->value();
    if (agv && typed_ms != inThousandths(agv->turnTime_s))
        emit turnTimeChanged(robot(), typed_ms * 1e-3);
}

void CalibrationPanel::sendTurnSpeed()
{
    const int typed_mm_s = m_ui->wheelSpeedSpin->value();
    const int before_mm_s = std::exchange(m_speedOfSleeptime_mm_s, typed_mm_s);
    if (!current() || typed_mm_s == before_mm_s)
        return;
    emit turnSpeedChanged(robot(), typed_mm_s * 1e-3);
    m_ui->sleeptimeSpin->setValue(
        static_cast<int>(std::lround(1.0 * m_ui->sleeptimeSpin->value() * before_mm_s / typed_mm_s)));
    sendTurnTime();
}

void CalibrationPanel::applyTurnTime(int robot, double seconds)
{
    const AgvSnapshot* agv = current();
    if (!agv || agv->id.number != robot)
        return;
    m_ui->sleeptimeSpin->setValue(inThousandths(seconds));
    emit turnTimeChanged(robot, seconds);
    emit turnTimeApplied(robot, seconds, agv->turnSpeed_m_s);
}

void CalibrationPanel::showKept(int robot, const QString& sentence)
{
    m_ui->resultCard->showKept(robot, sentence);
}

void CalibrationPanel::retake()
{
    const QModelIndexList rows = m_ui->stopTable->selectionModel()->selectedRows();
    if (!rows.isEmpty() && m_ui->retakeButton->isEnabled())
        emit retakeStopRequested(robot(), rows.first().row());
}

void CalibrationPanel::copyTable() const { QGuiApplication::clipboard()->setText(m_stops.toText()); }

void CalibrationPanel::showSnapshot(const PlantSnapshot& snapshot)
{
    m_snapshot = snapshot;
    showRobot();
}

void CalibrationPanel::showRobot()
{
    const AgvSnapshot* agv = current();
    if (!agv) {
        updateActions();
        return;
    }
    m_ui->progress->setTurn(agv->turn, stopsOf(m_ui->stopsCombo->currentIndex()) + 1);
    m_stops.setTurn(agv->turn);
    m_ui->fitPlot->setEstimate(agv->turn.result ? agv->turn.result : agv->turn.preview);
    showSettings(*agv);
    showPhase(*agv);
    showPreview(agv->turn);
    m_ui->resultCard->showAgv(nameOf(*agv), *agv);
    updateActions();
}

void CalibrationPanel::showSettings(const AgvSnapshot& agv)
{
    // Another AGV was chosen, or the session reports a new value: show it. Otherwise what stands in a field
    // is what the operator is typing.
    const Settings news{agv.id.number, agv.turnTime_s, agv.turnSpeed_m_s};
    const Settings shown = std::exchange(m_shown, news);
    const bool isOther = shown.robot != news.robot;
    if (isOther || shown.turnTime_s != news.turnTime_s)
        m_ui->sleeptimeSpin->setValue(inThousandths(news.turnTime_s));
    if (isOther || shown.turnSpeed_m_s != news.turnSpeed_m_s)
        showTurnSpeed(news.turnSpeed_m_s);
}

void CalibrationPanel::showTurnSpeed(double metresPerSecond)
{
    m_speedOfSleeptime_mm_s = inThousandths(metresPerSecond);
    m_ui->wheelSpeedSpin->setValue(m_speedOfSleeptime_mm_s);
}

void CalibrationPanel::showPhase(const AgvSnapshot& agv)
{
    const TurnSnapshot& turn = agv.turn;
    QString text;
    if (turn.phase == TurnPhase::Solving) {
        text = Words::turnPhase(turn.phase) + QStringLiteral(" …");
    } else if (isRunning(turn.phase)) {
        text = tr("Stop %1 of %2, %3. %4 left.")
                   .arg(turn.stop)
                   .arg(turn.stopCount)
                   .arg(Words::turnPhase(turn.phase), Words::seconds(std::ceil(turn.timeLeft_s)));
    } else {
        text = obstacleToStart(agv);
        if (text.isEmpty() && turn.phase == TurnPhase::Idle)
            text = tr("Ready. %1 turns once on the spot: keep %2 around it clear.")
                       .arg(nameOf(agv), Words::millimetres(0.5));
    }
    m_ui->phaseLabel->setText(text);
    m_ui->phaseLabel->setVisible(!text.isEmpty());
}

void CalibrationPanel::showPreview(const TurnSnapshot& turn)
{
    const QString text = isRunning(turn.phase) && turn.preview ? ResultText::soFar(*turn.preview) : QString();
    m_ui->previewLabel->setText(text);
    m_ui->previewLabel->setVisible(!text.isEmpty());
}

void CalibrationPanel::updateActions()
{
    const AgvSnapshot* agv = current();
    const bool running = canAbort();
    m_ui->initialiseButton->setEnabled(canStart());
    m_ui->abortButton->setEnabled(running);
    for (QWidget* field :
         {static_cast<QWidget*>(m_ui->sleeptimeSpin), static_cast<QWidget*>(m_ui->wheelSpeedSpin),
          static_cast<QWidget*>(m_ui->kindCombo), static_cast<QWidget*>(m_ui->directionCombo),
          static_cast<QWidget*>(m_ui->stopsCombo), static_cast<QWidget*>(m_ui->dwellSpin),
          static_cast<QWidget*>(m_ui->adaptiveCheck)})
        field->setEnabled(agv && !running);
    const bool chosen = m_ui->stopTable->selectionModel()->hasSelection();
    m_ui->retakeButton->setEnabled(chosen && agv && agv->turn.phase == TurnPhase::Finished && canStart());
    m_ui->copyButton->setEnabled(m_stops.rowCount() > 0);
    emit actionsChanged();
}

void CalibrationPanel::retranslate()
{
    m_ui->stopTable->setHint(tr("No turn yet. Press Calibrate: each stop adds a row with the tags read and "
                                "their RSSI."));
    if (m_plant.agvs.empty())
        m_ui->phaseLabel->setText(tr("The plant file names no AGV."));
    showRobot();
}

void CalibrationPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace agv::gui
