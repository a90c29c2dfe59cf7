// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/dialog_parts.h"

#include <QFormLayout>
#include <QLabel>

namespace agv::gui {

void showStatusGlyph(QLabel& label, Glyph glyph, const Theme& theme)
{
    const QColor colour = glyph == Glyph::Error     ? theme.error
                          : glyph == Glyph::Warning ? theme.warning
                                                    : theme.mutedText;
    label.setPixmap(glyphIcon(glyph, colour, colour).pixmap(QSize(16, 16), label.devicePixelRatioF()));
}

void centreLabels(QFormLayout& form)
{
    for (int row = 0; row < form.rowCount(); ++row) {
        QLayoutItem* item = form.itemAt(row, QFormLayout::LabelRole);
        if (item && item->widget())
            item->widget()->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
    }
}

} // namespace agv::gui
