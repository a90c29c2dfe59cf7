// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QString>

namespace agv::gui {

/// Says what is wrong with the plant file, before there is a window, and offers the ways on. Nothing in the
/// file is changed.
class PlantFileDialog : public QMessageBox {
    Q_OBJECT
public:
    enum class Choice { Quit, OtherFile, BuiltInPlant };

    /// `reason` names the file, the place and the remedy.
    explicit PlantFileDialog(const QString& reason, QWidget* parent = nullptr);

    Choice choice() const; ///< after the dialog has closed

    /// A plant file the operator picks, empty when none.
    static QString askForFile();

private:
    QPushButton* m_other;
    QPushButton* m_builtIn;
};

} // namespace agv::gui
