// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>

class QApplication;

namespace agv::gui {

/// Style, icon and names of the application, and the texts of `locale` (its translation when there is one,
/// English otherwise). Call once after the QApplication is made and before the first window; call again to
/// change the language while it runs.
void setUpApplication(QApplication& application, const QLocale& locale);

} // namespace agv::gui
