// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/shift_panel.h"

#include "gui/dialog_parts.h"
#include "gui/result_text.h"
#include "gui/turn_progress.h"
#include "model/words.h"
#include "ui_shift_panel.h"

#include <QEvent>

#include <algorithm>

namespace agv::gui {

using model::ShiftCalibration;
using model::ShiftCheck;
using Outcome = ShiftCalibration::Outcome;

namespace {

QString numbers(const std::vector<int>& robots)
{
    QStringList texts;
    for (const int robot : robots)
        texts << QString::number(robot);
    return texts.join(QStringLiteral(", "));
}

/// "1 min 23 s"
QString spanText(double seconds)
{
    const int whole = static_cast<int>(seconds + 0.5);
    return whole < 60 ? QStringLiteral("%1\u00a0s").arg(whole)
                      : QStringLiteral("%1\u00a0min %2\u00a0s").arg(whole / 60).arg(whole % 60);
}

} // namespace

ShiftPanel::ShiftPanel(QWidget* parent) : QWidget(parent), m_ui(std::make_unique<Ui::ShiftPanel>())
{
    m_ui->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    m_ui->content->setAttribute(Qt::WA_StyledBackground);
    connect(m_ui->checkButton, &QPushButton::clicked, this, &ShiftPanel::check);
    connect(m_ui->calibrateButton, &QPushButton::clicked, this, &ShiftPanel::calibrate);
    connect(m_ui->stopButton, &QPushButton::clicked, this, &ShiftPanel::stop);
    connect(m_ui->allButton, &QToolButton::toggled, this, &ShiftPanel::showChecks);
    showChecks();
    showTurns();
}

ShiftPanel::~ShiftPanel() = default;

void ShiftPanel::setPlant(const PlantLayout& plant) { m_plant = plant; }

void ShiftPanel::setTheme(const Theme& theme)
{
    m_theme = theme;
    showChecks();
    showTurns();
}

void ShiftPanel::showSnapshot(const PlantSnapshot& snapshot)
{
    m_snapshot = snapshot;
    if (m_checkingSince)
        updateChecks();
    updateCalibration();
    updateButtons();
}

void ShiftPanel::check()
{
    m_checks.clear();
    m_checkingSince = m_snapshot.time;
    m_ui->shiftVerdictLabel->clear();
    updateChecks();
}

void ShiftPanel::updateChecks()
{
    const std::vector<ShiftCheck> now =
        model::ShiftChecks::of(m_plant, m_snapshot, m_facts ? m_facts() : model::ShiftFacts{});
    // A check that passed once has passed: an antenna between two tags reads nothing for a moment.
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (i == m_checks.size())
            m_checks.push_back(now[i]);
        else if (!m_checks[i].passed)
            m_checks[i] = now[i];
    }
    const bool allPassed = std::ranges::all_of(m_checks, &ShiftCheck::passed);
    if (allPassed || m_snapshot.time - *m_checkingSince >= checkTime)
        endChecks();
    showChecks();
    updateButtons();
}

void ShiftPanel::endChecks()
{
    m_checkingSince.reset();
    const auto failures = std::ranges::count(m_checks, false, &ShiftCheck::passed);
    QStringList failed;
    for (const ShiftCheck& each : m_checks) {
        if (!each.passed)
            failed << tr("%1 (%2)").arg(each.what, each.cause);
    }
    emit verdictReached(failures == 0, failures == 0
                                           ? tr("Start of shift: all %1 checks passed").arg(m_checks.size())
                                           : tr("Start of shift: %1 of %2 checks failed: %3")
                                                 .arg(failures)
                                                 .arg(m_checks.size())
                                                 .arg(failed.join(QStringLiteral("; "))));
}

void ShiftPanel::showChecks()
{
    const auto failures = std::ranges::count(m_checks, false, &ShiftCheck::passed);
    const bool isChecking = m_checkingSince.has_value();
    m_ui->summaryIcon->setVisible(!m_checks.empty() && !isChecking);
    m_ui->allButton->setVisible(!m_checks.empty());
    showStatusGlyph(*m_ui->summaryIcon, failures == 0 ? Glyph::Check : Glyph::Warning, m_theme);
    m_ui->summaryLabel->setText(
        m_checks.empty() ? tr("Before the shift: press the button above. Nothing moves.")
        : isChecking     ? tr("Checking …")
        : failures == 0  ? tr("All %1 checks passed").arg(m_checks.size())
                         : tr("%1 of %2 checks failed").arg(failures).arg(m_checks.size()));
    QString html;
    for (const ShiftCheck& each : m_checks) {
        if (each.passed && !m_ui->allButton->isChecked())
            continue;
        html += QStringLiteral("<p style='margin:0 0 6px 0'>%1 <b>%2</b>: %3.%4</p>")
                    .arg(each.passed ? QStringLiteral("\u2713")
                                     : QStringLiteral("<span style='color:%1'><b>\u2717</b></span>")
                                           .arg(m_theme.warning.name()),
                         each.what.toHtmlEscaped(), each.cause.toHtmlEscaped(),
                         each.remedy.isEmpty() ? QString()
                                               : QStringLiteral("<br>") + each.remedy.toHtmlEscaped());
    }
    m_ui->checksLabel->setText(isChecking ? QString() : html);
    m_ui->checksLabel->setVisible(!isChecking && !html.isEmpty());
}

std::vector<int> ShiftPanel::readyRobots() const
{
    std::vector<int> robots;
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        if (agv.robotLink.state == LinkState::Up && agv.readerLink.state == LinkState::Up &&
            agv.robotState != RobotState::Error)
            robots.push_back(agv.id.number);
    }
    return robots;
}

void ShiftPanel::calibrate()
{
    m_calibration.start(readyRobots(), m_snapshot.time);
    m_ui->shiftVerdictLabel->clear();
    updateCalibration();
    updateButtons();
}

void ShiftPanel::stop()
{
    if (!m_calibration.isRunning())
        return;
    const int robot = m_calibration.entries()[m_calibration.current()].robot;
    m_calibration.stop();
    emit abortWanted(robot);
    updateCalibration();
    updateButtons();
}

void ShiftPanel::updateCalibration()
{
    const std::optional<int> robot = m_calibration.update(m_snapshot);
    if (robot)
        emit turnWanted(*robot);
    const bool wasRunning = std::exchange(m_wasCalibrating, m_calibration.isRunning());
    if (wasRunning && !m_calibration.isRunning())
        endCalibration();
    showTurns();
}

std::vector<int> ShiftPanel::robotsIn(Outcome outcome) const
{
    std::vector<int> robots;
    for (const ShiftCalibration::Entry& entry : m_calibration.entries()) {
        if (entry.outcome == outcome)
            robots.push_back(entry.robot);
    }
    return robots;
}

void ShiftPanel::endCalibration()
{
    const QString time = spanText(secondsFrom(m_snapshot.time - m_calibration.began()));
    const bool good = m_calibration.foundAll();
    const bool all = m_calibration.entries().size() == m_snapshot.agvs.size();
    const QString found = numbers(robotsIn(Outcome::Found));
    const auto failures = std::ranges::count(m_checks, false, &ShiftCheck::passed);
    const QString verdict =
        good && all && failures > 0 ? tr("All AGVs (%1) were located in %2, but %3 of the checks failed.")
                                          .arg(found, time)
                                          .arg(failures)
        : good && all     ? tr("Ready: all AGVs (%1) were located in %2.").arg(found, time)
        : good            ? tr("Located in %2: AGV %1. The others could not be calibrated.").arg(found, time)
        : found.isEmpty() ? tr("Not ready: no AGV was located.")
                          : tr("Not ready: located was only AGV %1.").arg(found);
    m_ui->shiftVerdictLabel->setText(QStringLiteral("<b>%1</b>").arg(verdict.toHtmlEscaped()));
    emit verdictReached(good && all && failures == 0, tr("Start of shift: %1").arg(verdict));
}

void ShiftPanel::showTurns()
{
    QString html;
    for (const ShiftCalibration::Entry& entry : m_calibration.entries()) {
        QString text;
        switch (entry.outcome) {
        case Outcome::Waiting:
            text = m_calibration.isRunning() ? tr("waits") : tr("not calibrated");
            break;
        case Outcome::Running:
            text = tr("turns …");
            break;
        case Outcome::Found:
        case Outcome::NotFound:
            text = ResultText::headline(*entry.result) + QStringLiteral(": ") +
                   ResultText::shortForm(*entry.result);
            break;
        case Outcome::Stopped:
            text = tr("stopped");
            break;
        case Outcome::NotStarted:
            text = tr("did not start; the event log says why");
            break;
        }
        html += QStringLiteral("<p style='margin:0 0 6px 0'><b>%1</b>: %2</p>")
                    .arg(tr("AGV %1").arg(entry.robot), text.toHtmlEscaped());
    }
    if (m_ui->turnsLabel->text() != html)
        m_ui->turnsLabel->setText(html);
    m_ui->turnsLabel->setVisible(!html.isEmpty());
}

void ShiftPanel::updateButtons()
{
    const bool turning = std::ranges::any_of(
        m_snapshot.agvs, [](const AgvSnapshot& agv) { return isRunning(agv.turn.phase); });
    const std::vector<int> ready = readyRobots();
    m_ui->checkButton->setEnabled(!m_checkingSince && !m_calibration.isRunning());
    m_ui->calibrateButton->setEnabled(!m_checkingSince && !m_calibration.isRunning() && !turning &&
                                      !ready.empty());
    m_ui->calibrateButton->setText(ready.empty()
                                       ? tr("Calibrate one after the &other")
                                       : tr("Calibrate AGV %1 one after the &other").arg(numbers(ready)));
    m_ui->stopButton->setEnabled(m_calibration.isRunning());
}

void ShiftPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        showChecks();
        showTurns();
        updateButtons();
    }
    QWidget::changeEvent(event);
}

} // namespace agv::gui
