// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gui/theme.h"

#include <QFont>

class QCPAxis;

namespace agv::gui {

/// The look that all axes of the program share.
void styleAxis(QCPAxis& axis, const Theme& theme, const QFont& font);

} // namespace agv::gui
