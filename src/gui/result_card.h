// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "core/snapshot.h"
#include "core/turn.h"
#include "gui/theme.h"

#include <map>
#include <memory>

namespace Ui {
class ResultCard;
}

namespace agv::gui {

enum class Verdict;

/// How the last turn of an AGV ended: verdict, pose and uncertainty in words, what to do, and the sleeptime
/// that would fit, to be applied and taken back. Hides itself while there is nothing to tell.
class ResultCard : public QFrame {
    Q_OBJECT
public:
    explicit ResultCard(QWidget* parent = nullptr);
    ~ResultCard() override;

    void setTheme(const Theme& theme);
    /// `name`: of the AGV, for the sentences.
    void showAgv(const QString& name, const AgvSnapshot& agv);
    /// Where the sleeptime that was applied last is kept; stands on the card until the next turn.
    void showKept(int robot, const QString& sentence);

signals:
    /// The suggestion, or on undo what stood before it.
    void turnTimeApplied(int robot, double seconds);

protected:
    void changeEvent(QEvent* event) override;

private:
    /// A suggestion that was applied.
    struct Applied {
        std::shared_ptr<const TurnEstimate> result; ///< whose suggestion it was
        double before_s = 0.0;
        double now_s = 0.0;
        QString kept;
    };
    void showResult(const QString& name);
    void showFailure();
    void showSuggestion();
    void setVerdict(Verdict verdict, const QString& headline, const QString& text, const QString& reasons);
    void apply();
    void undo();
    const Applied* applied() const;

    std::unique_ptr<Ui::ResultCard> m_ui;
    Theme m_theme = Theme::light();
    QString m_name;
    AgvSnapshot m_agv;
    std::map<int, Applied> m_applied; ///< by AGV
    int m_shownVerdict = -1;
};

} // namespace agv::gui
