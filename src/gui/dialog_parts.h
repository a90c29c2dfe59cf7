// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gui/glyphs.h"
#include "gui/theme.h"

class QFormLayout;
class QLabel;

namespace agv::gui {

/// Shows `glyph` before a line of status: coloured for what is not as it should be, else grey.
void showStatusGlyph(QLabel& label, Glyph glyph, const Theme& theme);

/// Labels in the middle of their rows; Qt lets them stand at the top.
void centreLabels(QFormLayout& form);

} // namespace agv::gui
