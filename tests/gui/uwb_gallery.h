// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>

/// Pictures of the window's UWB panels and dialogs: FOLDER/NAME-SUFFIX.png.
void saveUwbPictures(const QString& folder, const QString& suffix, QSize windowSize);
