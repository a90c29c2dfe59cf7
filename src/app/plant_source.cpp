// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plant_source.h"

#include "core/plant_file.h"

#include <QFile>

namespace agv::app {
namespace {

Result<PlantDocument> builtIn(const char* name)
{
    QFile file(QString(":/") + name);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::NotFound, std::string("This program was built without ") + name +
                                                ": name a plant file with --plant");
    }
    return PlantDocument::fromText(file.readAll().toStdString(), name);
}

} // namespace

Result<LoadedPlant> loadPlant(const PlantChoice& choice)
{
    const Result<PlantDocument> document =
        choice.plantFile ? PlantDocument::fromFile(*choice.plantFile)
                         : builtIn(choice.smallField ? "small-field.json" : "plant.json");
    if (!document)
        return std::unexpected(document.error());
    return LoadedPlant{document->layout(), document->warnings()};
}

} // namespace agv::app
