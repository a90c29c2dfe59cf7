// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/uwb_snapshot.h"
#include "gui/theme.h"
#include "model/correction_table_model.h"

namespace agv::gui {

class UwbEditor;
class UwbTablePanel;

/// The range corrections, anchors by tags. Edits go to the editor at once and are undone there.
class CorrectionDialog : public QDialog {
    Q_OBJECT
public:
    explicit CorrectionDialog(UwbEditor& editor, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /// Null: nothing is known of the unit.
    void showUwb(const UwbSnapshot* uwb);

private:
    void update();

    UwbEditor& m_editor;
    UwbTablePanel* m_panel;
    model::CorrectionTableModel m_model;
    std::vector<int> m_heard;
};

} // namespace agv::gui
