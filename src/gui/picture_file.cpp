// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture_file.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>

namespace agv::gui {
namespace {

class PictureTexts {
    Q_DECLARE_TR_FUNCTIONS(agv::gui::PictureTexts)
public:
    static QString png() { return tr("Picture (*.png)"); }
    static QString svg() { return tr("Drawing (*.svg)"); }
    static QString pdf() { return tr("Document (*.pdf)"); }
};

using Paint = std::function<void(QPainter&)>;

QByteArray asPng(QSizeF size, const Paint& paint)
{
    constexpr double ratio = 2.0; // sharp in print and on screens of high density
    QImage image((size * ratio).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::white);
    {
        QPainter painter(&image);
        paint(painter);
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray asSvg(QSizeF size, const Paint& paint)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size.toSize());
    generator.setViewBox(QRectF(QPointF(), size));
    generator.setTitle(QStringLiteral("AGV Console"));
    QPainter painter(&generator);
    paint(painter);
    painter.end();
    return bytes;
}

QByteArray asPdf(QSizeF size, const Paint& paint)
{
    constexpr int dotsPerInch = 96; // one pixel of the screen is one dot of the page
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(dotsPerInch);
    writer.setPageSize(QPageSize(size / dotsPerInch, QPageSize::Inch, {}, QPageSize::ExactMatch));
    writer.setPageMargins({});
    writer.setCreator(QStringLiteral("AGV Console"));
    QPainter painter(&writer);
    paint(painter);
    painter.end();
    return bytes;
}

} // namespace

QStringList pictureFilters() { return {PictureTexts::png(), PictureTexts::svg(), PictureTexts::pdf()}; }

Result<void> savePicture(const QString& path, QSizeF size, const Paint& paint)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    QByteArray bytes;
    if (ending == QLatin1String("png"))
        bytes = asPng(size, paint);
    else if (ending == QLatin1String("svg"))
        bytes = asSvg(size, paint);
    else if (ending == QLatin1String("pdf"))
        bytes = asPdf(size, paint);
    else
        return failure(ErrorCode::BadInput, path.toStdString() + ": a picture ends in .png, .svg or .pdf");
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        return failure(ErrorCode::Io, path.toStdString() + ": " + file.errorString().toStdString());
    return {};
}

} // namespace agv::gui
