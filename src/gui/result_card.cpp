// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/result_card.h"

#include "gui/glyphs.h"
#include "gui/result_text.h"
#include "gui/turn_progress.h"
#include "model/messages.h"
#include "model/words.h"
#include "ui_result_card.h"

#include <QEvent>
#include <QStyle>

#include <cmath>

namespace agv::gui {

using model::Words;

namespace {

/// Sleeptimes are set in whole milliseconds.
double wholeMs(double seconds) { return std::round(seconds * 1e3) * 1e-3; }

bool isSameMs(double a_s, double b_s) { return std::lround(a_s * 1e3) == std::lround(b_s * 1e3); }

} // namespace

ResultCard::ResultCard(QWidget* parent) : QFrame(parent), m_ui(std::make_unique<Ui::ResultCard>())
{
    m_ui->setupUi(this);
    connect(m_ui->applyButton, &QPushButton::clicked, this, &ResultCard::apply);
    connect(m_ui->undoButton, &QPushButton::clicked, this, &ResultCard::undo);
    hide();
}

ResultCard::~ResultCard() = default;

void ResultCard::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_shownVerdict = -1;
    showAgv(m_name, m_agv);
}

void ResultCard::showAgv(const QString& name, const AgvSnapshot& agv)
{
    m_name = name;
    m_agv = agv;
    const TurnSnapshot& turn = agv.turn;
    if (turn.phase == TurnPhase::Aborted || turn.phase == TurnPhase::Failed)
        showFailure();
    else if (turn.result && !isRunning(turn.phase))
        showResult(name);
    else
        hide();
    showSuggestion();
}

void ResultCard::showKept(int robot, const QString& sentence)
{
    const auto found = m_applied.find(robot);
    if (found == m_applied.end())
        return;
    found->second.kept = sentence;
    showSuggestion();
}

void ResultCard::showResult(const QString& name)
{
    const TurnEstimate& estimate = *m_agv.turn.result;
    setVerdict(ResultText::verdict(estimate), ResultText::headline(estimate),
               ResultText::sentence(name, estimate), ResultText::reasons(estimate).join(QLatin1Char('\n')));
}

void ResultCard::showFailure()
{
    const bool aborted = m_agv.turn.phase == TurnPhase::Aborted;
    setVerdict(aborted ? Verdict::Warning : Verdict::Error, aborted ? tr("Turn aborted") : tr("Turn failed"),
               model::Messages::sentence(m_agv.turn.message),
               m_agv.mayBeMoving
                   ? tr("The AGV may still be moving: the connection was lost while its wheels were turning. "
                        "Go and look before you start again.")
                   : tr("The wheels have been set to zero. Press Calibrate to start again."));
}

void ResultCard::showSuggestion()
{
    const TurnSnapshot& turn = m_agv.turn;
    // It fits the wheel speed of its turn alone.
    const bool valid =
        turn.phase == TurnPhase::Finished && turn.result && turn.wheelSpeed_m_s == m_agv.turnSpeed_m_s;
    const QString text = valid ? ResultText::suggestion(*turn.result, turn.stopCount - 1) : QString();
    const bool differs = !text.isEmpty() && !isSameMs(*turn.result->suggestedTurnTime_s, m_agv.turnTime_s);
    m_ui->suggestionLabel->setText(text);
    m_ui->suggestionLabel->setVisible(differs);
    m_ui->applyButton->setVisible(differs);
    const Applied* done = valid ? applied() : nullptr;
    const bool inUse = done && isSameMs(done->now_s, m_agv.turnTime_s);
    m_ui->appliedLabel->setVisible(inUse && !done->kept.isEmpty());
    m_ui->undoButton->setVisible(inUse);
    if (!inUse)
        return;
    m_ui->appliedLabel->setText(done->kept);
    m_ui->undoButton->setText(tr("Undo: sleeptime %1 again").arg(Words::milliseconds(done->before_s)));
}

const ResultCard::Applied* ResultCard::applied() const
{
    const auto found = m_applied.find(m_agv.id.number);
    return found != m_applied.end() && found->second.result == m_agv.turn.result ? &found->second : nullptr;
}

void ResultCard::apply()
{
    const std::shared_ptr<const TurnEstimate>& result = m_agv.turn.result;
    if (!result || !result->suggestedTurnTime_s)
        return;
    const double now_s = wholeMs(*result->suggestedTurnTime_s);
    m_applied[m_agv.id.number] = {result, m_agv.turnTime_s, now_s, {}};
    emit turnTimeApplied(m_agv.id.number, now_s);
}

void ResultCard::undo()
{
    const Applied* done = applied();
    if (!done)
        return;
    const double before_s = done->before_s;
    m_applied.erase(m_agv.id.number);
    emit turnTimeApplied(m_agv.id.number, before_s);
}

void ResultCard::setVerdict(Verdict verdict, const QString& headline, const QString& text,
                            const QString& reasons)
{
    const bool good = verdict == Verdict::Good;
    const bool warning = verdict == Verdict::Warning;
    if (static_cast<int>(verdict) != m_shownVerdict) {
        m_shownVerdict = static_cast<int>(verdict);
        const Glyph glyph = good ? Glyph::Check : warning ? Glyph::Warning : Glyph::Error;
        const QColor colour = good ? m_theme.text : warning ? m_theme.warning : m_theme.error;
        m_ui->verdictIcon->setPixmap(
            glyphIcon(glyph, colour, colour).pixmap(QSize(20, 20), devicePixelRatioF()));
        setProperty("verdict", good      ? QStringLiteral("good")
                               : warning ? QStringLiteral("warning")
                                         : QStringLiteral("error"));
        style()->unpolish(this);
        style()->polish(this);
    }
    m_ui->verdictLabel->setText(headline);
    m_ui->resultLabel->setText(text);
    m_ui->resultLabel->setVisible(!text.isEmpty());
    m_ui->reasonsLabel->setText(reasons);
    m_ui->reasonsLabel->setVisible(!reasons.isEmpty());
    show();
}

void ResultCard::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        m_ui->retranslateUi(this);
        showAgv(m_name, m_agv);
    }
    QFrame::changeEvent(event);
}

} // namespace agv::gui
