// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSizeF>
#include <QString>

#include "core/result.h"

#include <functional>

class QPainter;

namespace agv::gui {

/// Replaces the file `path` by a picture of `size` (px), painted by `paint`. The name's ending says how: .png
/// (twice the pixels), .svg or .pdf (lines stay lines, text stays text). The file holds the old or the new
/// picture, never a part. BadInput for another ending, Permission or Io with the reason.
Result<void> savePicture(const QString& path, QSizeF size, const std::function<void(QPainter&)>& paint);

/// For a file dialog: the kinds of pictures, the first being .png.
QStringList pictureFilters();

} // namespace agv::gui
