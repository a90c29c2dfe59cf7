// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/plot/axis_style.h"

#include <qcustomplot.h>

namespace agv::gui {

void styleAxis(QCPAxis& axis, const Theme& theme, const QFont& font)
{
    axis.setBasePen(QPen(theme.strongBorder));
    axis.setTickPen(QPen(theme.strongBorder));
    axis.setSubTickPen(Qt::NoPen);
    axis.setTickLabelColor(theme.mutedText);
    axis.setLabelColor(theme.mutedText);
    axis.grid()->setPen(QPen(theme.border, 1.0));
    axis.grid()->setZeroLinePen(Qt::NoPen);
    axis.setTickLabelFont(font);
    axis.setLabelFont(font);
}

} // namespace agv::gui
