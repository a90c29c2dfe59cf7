// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/jog_panel.h"

#include "gui/jog_hold.h"
#include "gui/jog_pad.h"
#include "model/messages.h"
#include "model/words.h"
#include "ui_jog_panel.h"

#include <QEvent>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace agv::gui {

using model::Messages;
using model::Words;

namespace {

constexpr int slowest_mm_s = 10;
constexpr double finePart = 0.2;

} // namespace

JogPanel::JogPanel(QWidget* parent)
    : QWidget(parent),
      m_ui(std::make_unique<Ui::JogPanel>()),
      m_hold(new JogHold(this))
{
    m_ui->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    m_ui->jogSpeedSlider->setRange(slowest_mm_s, static_cast<int>(mmFromMetres(mostJogSpeed_m_s)));
    m_ui->jogSpeedSlider->setValue(static_cast<int>(mmFromMetres(usualJogSpeed_m_s)));
    m_ui->latchFrame->hide();
    setTabOrder(m_ui->jogPad, m_ui->jogPad->lastField());
    setTabOrder(m_ui->jogPad->lastField(), m_ui->releaseButton);
    connectPad();
    connectRest();
    retranslate();
}

JogPanel::~JogPanel() = default;

void JogPanel::connectPad()
{
    connect(m_ui->jogPad, &JogPad::pressed, this, &JogPanel::press);
    connect(m_ui->jogPad, &JogPad::directionChanged, this, [this](JogDirection direction) {
        m_direction = direction;
        updateSpeed();
    });
    connect(m_ui->jogPad, &JogPad::released, m_hold, &JogHold::end);
    connect(m_ui->jogPad, &JogPad::refused, this, [this] {
        m_ownRefusal = tr("It is driven already: mouse and keys do not drive together.");
        showState();
    });
    connect(m_ui->jogPad, &JogPad::stopPressed, this, [this] { emit stopRequested(robot()); });
    connect(m_hold, &JogHold::pressed, this,
            [this](const JogCommand& command) { emit pressed(m_heldRobot, command); });
    connect(m_hold, &JogHold::held, this,
            [this](const JogCommand& command) { emit held(m_heldRobot, command); });
    connect(m_hold, &JogHold::released, this,
            [this](const JogCommand& command, JogReason why) { emit released(m_heldRobot, command, why); });
    connect(m_hold, &JogHold::stalled, this, [this] { m_ui->jogPad->cancel(JogReason::WindowStalled); });
}

void JogPanel::connectRest()
{
    connect(m_ui->jogRobotCombo, &QComboBox::currentIndexChanged, this, &JogPanel::onRobotChosen);
    connect(m_ui->jogSpeedSlider, &QSlider::valueChanged, this, &JogPanel::updateSpeed);
    connect(m_ui->fineCheck, &QCheckBox::toggled, this, &JogPanel::updateSpeed);
    connect(m_ui->releaseButton, &QPushButton::clicked, this, &JogPanel::stopAllReleased);
    const std::pair<QPushButton*, DockOrder> orders[] = {{m_ui->dockButton, DockOrder::Dock},
                                                         {m_ui->undockButton, DockOrder::Undock},
                                                         {m_ui->chargeButton, DockOrder::Charge}};
    for (const auto& [button, order] : orders)
        connect(button, &QPushButton::clicked, this,
                [this, wanted = order] { emit dockRequested(robot(), wanted); });
}

void JogPanel::setPlant(const PlantLayout& plant)
{
    m_plant = plant;
    const QSignalBlocker blocker(m_ui->jogRobotCombo);
    m_ui->jogRobotCombo->clear();
    for (const AgvConfig& agv : plant.agvs) {
        const QString name =
            agv.name.empty() ? tr("AGV %1").arg(agv.id.number) : QString::fromStdString(agv.name);
        m_ui->jogRobotCombo->addItem(name, agv.id.number);
    }
    setEnabled(!plant.agvs.empty());
    onRobotChosen();
}

void JogPanel::setTheme(const Theme& theme) { m_ui->jogPad->setTheme(theme); }

int JogPanel::robot() const { return m_ui->jogRobotCombo->currentData().toInt(); }

JogPad* JogPanel::pad() const { return m_ui->jogPad; }

void JogPanel::setRobot(int robot)
{
    const int index = m_ui->jogRobotCombo->findData(robot);
    if (index >= 0)
        m_ui->jogRobotCombo->setCurrentIndex(index);
}

void JogPanel::onRobotChosen()
{
    m_ui->jogPad->cancel(JogReason::OtherChosen);
    m_ownRefusal.clear();
    if (const AgvConfig* agv = m_plant.findAgv(RobotId{robot()})) {
        const double most_m_s = std::min(agv->maxSpeed_m_s, mostJogSpeed_m_s);
        m_ui->jogSpeedSlider->setMaximum(
            std::max(slowest_mm_s, static_cast<int>(std::lround(mmFromMetres(most_m_s)))));
    }
    updateSpeed();
    showState();
    emit robotChosen(robot());
}

double JogPanel::speed_m_s() const
{
    const double chosen = metresFromMm(m_ui->jogSpeedSlider->value());
    return m_ui->fineCheck->isChecked() ? std::max(chosen * finePart, metresFromMm(slowest_mm_s)) : chosen;
}

void JogPanel::updateSpeed()
{
    m_ui->speedValueLabel->setText(Words::millimetresPerSecond(speed_m_s()));
    m_hold->setSpeeds(jogSpeeds(m_direction, speed_m_s()));
}

void JogPanel::press(JogSource source, JogDirection direction)
{
    m_direction = direction;
    m_heldRobot = robot();
    m_ownRefusal.clear();
    if (!m_hold->begin(source, jogSpeeds(direction, speed_m_s()))) {
        m_ownRefusal = tr("This window did not react for a moment, so the press was not sent. Press again.");
        m_ui->jogPad->cancel(JogReason::WindowStalled);
    }
    showState();
}

const AgvSnapshot* JogPanel::current() const
{
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        if (agv.id.number == robot())
            return &agv;
    }
    return nullptr;
}

void JogPanel::showSnapshot(const PlantSnapshot& snapshot)
{
    m_snapshot = snapshot;
    showState();
}

QString JogPanel::sentence(const AgvSnapshot& agv) const
{
    const QString name = m_ui->jogRobotCombo->currentText();
    if (agv.jog.state == JogState::Driving)
        return tr("%1 drives: left wheel %2, right wheel %3.")
            .arg(name, Words::millimetresPerSecond(agv.commanded.left),
                 Words::millimetresPerSecond(agv.commanded.right));
    if (agv.jog.state == JogState::Spent)
        return tr("%1. Let go, then press again.").arg(Messages::sentence(agv.jog.note));
    if (!agv.jog.note.empty())
        return Messages::sentence(agv.jog.note) + QLatin1Char('.');
    if (!agv.jog.obstacle.empty())
        return tr("%1 cannot be driven now: %2.").arg(name, Messages::sentence(agv.jog.obstacle));
    return tr("Ready. %1 drives as long as you hold an arrow.").arg(name);
}

void JogPanel::showState()
{
    const AgvSnapshot* agv = current();
    const bool isLatched = agv && agv->jog.state == JogState::Latched;
    m_ui->latchFrame->setVisible(isLatched);
    m_ui->jogPad->setDriving(agv && agv->jog.state == JogState::Driving);
    const bool isPlain = !agv || (agv->jog.note.empty() && agv->jog.obstacle.empty());
    if (!m_ownRefusal.isEmpty())
        setSentence(m_ownRefusal, true);
    else
        setSentence(agv && !isLatched ? sentence(*agv) : QString(), !isPlain);
}

void JogPanel::setSentence(const QString& text, bool isWarning)
{
    m_ui->jogNotice->setText(text);
    m_ui->jogNotice->setVisible(isWarning && !text.isEmpty());
    m_ui->jogSentence->setText(text);
    m_ui->jogSentence->setVisible(!isWarning && !text.isEmpty());
}

void JogPanel::retranslate()
{
    m_ui->jogPad->retranslate();
    updateSpeed();
    showState();
}

void JogPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        retranslate();
    }
    QWidget::changeEvent(event);
}

void JogPanel::setSeen(bool seen)
{
    if (!seen) {
        m_ui->jogPad->cancel(JogReason::WindowHidden);
        m_ui->jogPad->clearFocus();
    }
    m_hold->setWatching(seen);
}

} // namespace agv::gui
