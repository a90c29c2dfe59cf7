// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/application_setup.h"

#include "gui/glyphs.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QStyleFactory>
#include <QTranslator>

namespace agv::gui {
namespace {

// The application owns its translators; the names find them again when the language changes.
void install(QApplication& application, const QString& name, const QLocale& locale, const QString& file,
             const QString& folder)
{
    delete application.findChild<QTranslator*>(name, Qt::FindDirectChildrenOnly);
    auto* translator = new QTranslator(&application);
    translator->setObjectName(name);
    if (translator->load(locale, file, QStringLiteral("_"), folder))
        QApplication::installTranslator(translator);
    else
        delete translator;
}

} // namespace

void setUpApplication(QApplication& application, const QLocale& locale)
{
    QApplication::setApplicationName(QStringLiteral("agv-console"));
    QApplication::setOrganizationName(QStringLiteral("agv-console"));
    QApplication::setDesktopFileName(QStringLiteral("agv-console"));
    QApplication::setWindowIcon(applicationIcon());
    if (QStyle* style = QStyleFactory::create(QStringLiteral("Fusion")))
        QApplication::setStyle(style);
    QLocale::setDefault(locale);
    install(application, QStringLiteral("qtTranslator"), locale, QStringLiteral("qtbase"),
            QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(application, QStringLiteral("agvTranslator"), locale, QStringLiteral("agv-console"),
            QStringLiteral(":/i18n"));
    // Qt appends this name to every title that does not end with it.
    QApplication::setApplicationDisplayName(
        QCoreApplication::translate("agv::gui::MainWindow", "AGV Console[*]").remove(QStringLiteral("[*]")));
}

} // namespace agv::gui
