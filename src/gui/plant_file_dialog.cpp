// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/plant_file_dialog.h"

#include <QFileDialog>
#include <QPushButton>

namespace agv::gui {

PlantFileDialog::PlantFileDialog(const QString& reason, QWidget* parent)
    : QMessageBox(parent),
      m_other(addButton(tr("&Choose another file…"), QMessageBox::AcceptRole)),
      m_builtIn(addButton(tr("&Use the built-in plant"), QMessageBox::ActionRole))
{
    setIcon(QMessageBox::Critical);
    setWindowTitle(tr("Plant file"));
    setText(tr("The plant file cannot be used."));
    setInformativeText(reason);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    QPushButton* quit = addButton(tr("&Quit"), QMessageBox::RejectRole);
    m_other->setObjectName(QStringLiteral("otherFileButton"));
    m_builtIn->setObjectName(QStringLiteral("builtInPlantButton"));
    quit->setObjectName(QStringLiteral("quitButton"));
    setDefaultButton(m_other);
    setEscapeButton(quit);
}

PlantFileDialog::Choice PlantFileDialog::choice() const
{
    if (clickedButton() == m_other)
        return Choice::OtherFile;
    return clickedButton() == m_builtIn ? Choice::BuiltInPlant : Choice::Quit;
}

QString PlantFileDialog::askForFile()
{
    return QFileDialog::getOpenFileName(nullptr, tr("Open plant file"), {},
                                        tr("Plant files (*.json);;All files (*)"));
}

} // namespace agv::gui
