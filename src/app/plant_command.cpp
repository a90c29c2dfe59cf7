// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plant_command.h"

#include "core/plant_file.h"
#include "core/tag_csv.h"
#include "core/text_file.h"

#include <ostream>
#include <unordered_map>

namespace agv::app {
namespace {

std::string counted(std::size_t count, const char* thing)
{
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

class PlantCommand {
public:
    PlantCommand(const PlantArguments& arguments, std::ostream& out, std::ostream& err)
        : m_arguments(arguments),
          m_out(out),
          m_err(err)
    {}

    int run()
    {
        const int status = act();
        const Result<void> flushed = flushStandardOutput(m_out);
        return flushed ? status : complain(flushed.error());
    }

private:
    int act()
    {
        switch (m_arguments.action) {
        case PlantAction::Check:
            return check();
        case PlantAction::ExportTags:
            return exportTags();
        case PlantAction::ImportTags:
            return importTags();
        }
        return 2;
    }

    int complain(const Error& error)
    {
        m_err << error.detail << '\n';
        return 1;
    }

    Result<PlantDocument> read(const std::string& file)
    {
        Result<PlantDocument> document = PlantDocument::fromFile(file);
        if (document) {
            for (const std::string& warning : document->warnings())
                m_err << "warning: " << warning << '\n';
        }
        return document;
    }

    int check()
    {
        int status = 0;
        for (const std::string& file : m_arguments.plantFiles) {
            const Result<PlantDocument> document = read(file);
            if (!document) {
                status = complain(document.error());
                continue;
            }
            const PlantLayout& plant = document->layout();
            m_out << file << ": ok, " << counted(plant.floorTags.size(), "floor tag") << ", "
                  << counted(plant.agvs.size(), "AGV") << ", " << counted(plant.stations.size(), "station")
                  << ", " << counted(plant.obstacles.size(), "obstacle") << ", "
                  << counted(plant.anchors.size(), "anchor") << '\n';
        }
        return status;
    }

    int exportTags()
    {
        const Result<PlantDocument> document = read(m_arguments.plantFiles.front());
        if (!document)
            return complain(document.error());
        const std::string table = writeTagCsv(document->layout().floorTags);
        if (!m_arguments.outFile) {
            m_out << table;
            return 0;
        }
        const Result<void> written = writeTextFile(*m_arguments.outFile, table);
        return written ? 0 : complain(written.error());
    }

    int importTags()
    {
        const Result<PlantDocument> document = read(m_arguments.plantFiles.front());
        if (!document)
            return complain(document.error());
        const Result<std::string> text = readTextFile(m_arguments.csvFile, maxPlantFileBytes);
        if (!text)
            return complain(text.error());
        Result<std::vector<FloorTag>> tags = readTagCsv(*text, m_arguments.csvFile);
        if (!tags)
            return complain(tags.error());
        PlantLayout plant = document->layout();
        const std::size_t surveyed = tags->size();
        plant.floorTags = m_arguments.merge ? merged(plant.floorTags, *tags) : std::move(*tags);
        const std::string& target = m_arguments.outFile.value_or(m_arguments.plantFiles.front());
        if (const Result<void> written = writePlantFile(target, plant, &*document); !written)
            return complain(written.error());
        m_out << target << ": " << counted(surveyed, "tag") << " taken over, "
              << counted(plant.floorTags.size(), "floor tag") << " now\n";
        return 0;
    }

    /// `tags` with the positions of those surveyed, and behind them the surveyed ones that are new.
    static std::vector<FloorTag> merged(std::vector<FloorTag> tags, const std::vector<FloorTag>& surveyed)
    {
        std::unordered_map<TagUid, std::size_t> places;
        for (std::size_t i = 0; i < tags.size(); ++i)
            places.emplace(tags[i].uid, i);
        for (const FloorTag& tag : surveyed) {
            if (const auto known = places.find(tag.uid); known != places.end())
                tags[known->second].position = tag.position;
            else
                tags.push_back(tag);
        }
        return tags;
    }

    const PlantArguments& m_arguments;
    std::ostream& m_out;
    std::ostream& m_err;
};

} // namespace

int runPlant(const PlantArguments& arguments, std::ostream& out, std::ostream& err)
{
    return PlantCommand(arguments, out, err).run();
}

} // namespace agv::app
