// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/snapshot.h"
#include "gui/theme.h"
#include "model/event_table_model.h"

#include <memory>

namespace Ui {
class EventPanel;
}

namespace agv::gui {

class EventFilter;

/// The event log: follows the newest line unless the operator has scrolled up; copyable.
/// Details are left out until they are asked for.
class EventPanel : public QWidget {
    Q_OBJECT
public:
    explicit EventPanel(QWidget* parent = nullptr);
    ~EventPanel() override;

    void setTheme(const Theme& theme);
    void addEvent(const EventEntry& event);
    QString selectedText() const; ///< the chosen lines, or all when none is chosen

protected:
    void changeEvent(QEvent* event) override;
    QSize sizeHint() const override { return {600, 150}; }

private:
    void copy() const;
    void showDetails(bool on);
    void fitRow(int row);
    void fitRows();
    void followNewest();

    std::unique_ptr<Ui::EventPanel> m_ui;
    model::EventTableModel m_events;
    bool m_following = true; ///< the newest line stays in sight
    EventFilter* m_shown;    ///< what the table shows of m_events
};

} // namespace agv::gui
