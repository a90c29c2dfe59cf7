// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/plant_layout.h"
#include "gui/theme.h"
#include "model/floor_tag_table_model.h"

#include <memory>

namespace Ui {
class FloorTagPanel;
}

namespace agv::gui {

class FloorTagFilter;
class WarningDelegate;

/// The list of floor tags: filtered, sorted, copied as CSV; shows a tag on the map. GUI thread.
class FloorTagPanel : public QWidget {
    Q_OBJECT
public:
    explicit FloorTagPanel(QWidget* parent = nullptr);
    ~FloorTagPanel() override;

    void setPlant(const PlantLayout& plant);
    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    /// The rows in sight, in their order, with a head; comma separated.
    QString csv() const;

signals:
    void placeChosen(agv::Point2 place);

protected:
    void changeEvent(QEvent* event) override;
    QSize sizeHint() const override { return {600, 180}; }

private:
    void fillStates();
    void chooseColumns(QPoint at);
    void restoreColumns();
    void updateHint();

    std::unique_ptr<Ui::FloorTagPanel> m_ui;
    model::FloorTagTableModel m_tags;
    FloorTagFilter* m_shown;
    WarningDelegate* m_states;
};

} // namespace agv::gui
