// SPDX-License-Identifier: GPL-3.0-or-later
#include "arch/source_rules.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string_view>

namespace agv::arch {

namespace fs = std::filesystem;
using namespace std::string_literals;

namespace {

constexpr std::string_view licenceLine = "// SPDX-License-Identifier: GPL-3.0-or-later";

struct SourceFile {
    std::string name; ///< relative to the root
    std::vector<std::string> lines;
};

bool isHeader(const fs::path& path) { return path.extension() == ".h"; }

bool isSource(const fs::path& path)
{
    static const std::set<std::string> extensions{".h", ".hpp", ".hh", ".cpp", ".cc", ".cxx"};
    return extensions.contains(path.extension().string());
}

std::vector<std::string> linesOf(const fs::path& path)
{
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

std::vector<SourceFile> sourcesBelow(const fs::path& root)
{
    std::vector<SourceFile> sources;
    for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator();
         ++entry) {
        if (entry->is_directory() && entry->path().filename() == "fixtures")
            entry.disable_recursion_pending();
        else if (entry->is_regular_file() && isSource(entry->path()))
            sources.push_back({fs::relative(entry->path(), root).generic_string(), linesOf(entry->path())});
    }
    std::ranges::sort(sources, {}, &SourceFile::name);
    return sources;
}

struct Include {
    std::size_t line = 0;
    std::string path;
    bool quoted = false;
};

/// `#include "path"` or `#include <path>`, with blanks wherever the preprocessor allows them.
std::optional<Include> includeIn(std::string_view text, std::size_t line)
{
    const auto skipBlanks = [&text] {
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    };
    for (const std::string_view token : {"#", "include"}) {
        skipBlanks();
        if (!text.starts_with(token))
            return std::nullopt;
        text.remove_prefix(token.size());
    }
    skipBlanks();
    if (text.empty() || (text.front() != '"' && text.front() != '<'))
        return std::nullopt;
    const bool quoted = text.front() == '"';
    text.remove_prefix(1);
    return Include{line, std::string(text.substr(0, text.find(quoted ? '"' : '>'))), quoted};
}

std::vector<Include> includesOf(const SourceFile& file)
{
    std::vector<Include> includes;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        if (auto include = includeIn(file.lines[i], i + 1))
            includes.push_back(*std::move(include));
    }
    return includes;
}

std::string firstFolder(const std::string& path) { return path.substr(0, path.find('/')); }
bool hasFolder(const std::string& path) { return path.contains('/'); }
bool isUpper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// Qt's class headers begin with Q and a capital or are called Qt...; QCustomPlot brings Qt with it.
bool isQt(const Include& include)
{
    const std::string& path = include.path;
    return (path.size() > 1 && path[0] == 'Q' && (isUpper(path[1]) || path[1] == 't')) ||
           path.starts_with("qcustomplot") || path.starts_with("ui_");
}

/// <QtWidgets>, <QtCore>, ...: a whole Qt library.
bool isUmbrella(const Include& include)
{
    const std::string& path = include.path;
    return path.size() > 2 && path.starts_with("Qt") && isUpper(path[2]) && !hasFolder(path) &&
           !path.starts_with("QtGlobal") && !path.starts_with("QtPlugin") && !path.starts_with("QtEndian") &&
           !path.starts_with("QtMath") && !path.starts_with("QtNumeric");
}

bool hasMocMacro(const SourceFile& file)
{
    return std::ranges::any_of(file.lines, [](std::string_view line) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        return line == "Q_OBJECT" || line == "Q_GADGET";
    });
}

class IncludeCheck {
public:
    IncludeCheck(const SourceFile& file, const ModuleRules& rules, std::vector<Violation>& violations)
        : m_file(file),
          m_module(firstFolder(file.name)),
          m_rules(rules),
          m_violations(violations)
    {}

    void run()
    {
        if (!hasFolder(m_file.name) || !m_rules.contains(m_module)) {
            add(1, "is in no module of the include rule");
            return;
        }
        const std::vector<Include> includes = includesOf(m_file);
        for (const Include& include : includes)
            check(include);
        checkMocOrder(includes);
    }

private:
    const ModuleRule& rule() const { return m_rules.at(m_module); }
    void add(std::size_t line, const std::string& problem)
    {
        m_violations.push_back({m_file.name, line, problem});
    }

    void check(const Include& include)
    {
        if (isQt(include) && !rule().qt)
            add(include.line, m_module + " is free of Qt and must not include <" + include.path + ">");
        else if (isUmbrella(include))
            add(include.line,
                "includes a whole Qt library, <" + include.path + ">; include single class headers");
        else if (include.quoted && !isQt(include))
            checkOwn(include);
        else if (m_rules.contains(firstFolder(include.path)) && hasFolder(include.path))
            add(include.line, "a header of this project is included with quotes: \"" + include.path + "\"");
    }

    void checkOwn(const Include& include)
    {
        const std::string used = firstFolder(include.path);
        if (include.path.ends_with(".moc"))
            return;
        if (!hasFolder(include.path) || !m_rules.contains(used))
            add(include.line, "\"" + include.path + "\" does not name its module; write \"module/header.h\"");
        else if (used != m_module && !rule().mayUse.contains(used))
            add(include.line, m_module + " must not include " + used + " (\"" + include.path + "\")");
    }

    /// moc 6.4.2 fails on <compare>, <concepts> and <ranges> of libstdc++ when they come before any Qt
    /// header.
    void checkMocOrder(const std::vector<Include>& includes)
    {
        if (!m_file.name.ends_with(".h") || !hasMocMacro(m_file) || includes.empty())
            return;
        const Include& first = includes.front();
        const auto own = m_rules.find(firstFolder(first.path));
        const bool bringsQt = isQt(first) || (first.quoted && own != m_rules.end() && own->second.qt);
        if (!bringsQt)
            add(first.line, "a header that moc reads includes a Qt header before anything else");
    }

    const SourceFile& m_file;
    std::string m_module;
    const ModuleRules& m_rules;
    std::vector<Violation>& m_violations;
};

bool isSnakeCase(const std::string& name)
{
    return std::ranges::all_of(
        name, [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; });
}

} // namespace

const ModuleRules& moduleRules()
{
    static const ModuleRules rules = [] {
        ModuleRules table{
            {"core", {{}, false}},
            {"protocol", {{"core"}, false}},
            {"estimation", {{"core"}, false}},
            {"procedure", {{"core"}, false}},
            {"recording", {{"core"}, false}},
            {"simulation", {{"core", "protocol"}, false}},
            {"link", {{"core"}, true}},
            {"simserver", {{"core", "protocol", "simulation"}, true}},
            {"session", {{"core", "protocol", "estimation", "procedure", "recording", "link"}, true}},
            {"model", {{"core"}, true}},
            {"gui", {{"core", "model"}, true}},
        };
        ModuleRule app{{}, true};
        for (const auto& [module, rule] : table)
            app.mayUse.insert(module);
        table.emplace("app", app);
        return table;
    }();
    return rules;
}

std::vector<std::string> findCycle(const ModuleRules& rules)
{
    std::vector<std::string> path;
    std::set<std::string> done;
    const std::function<bool(const std::string&)> closes = [&](const std::string& module) {
        const auto seen = std::ranges::find(path, module);
        if (seen != path.end()) {
            path.erase(path.begin(), seen);
            return true;
        }
        const auto rule = rules.find(module);
        if (rule == rules.end() || done.contains(module))
            return false;
        path.push_back(module);
        if (std::ranges::any_of(rule->second.mayUse, closes))
            return true;
        path.pop_back();
        done.insert(module);
        return false;
    };
    for (const auto& [module, rule] : rules) {
        if (closes(module))
            return path;
    }
    return {};
}

std::string toText(const Violation& violation)
{
    return violation.file + ":" + std::to_string(violation.line) + ": " + violation.problem;
}

std::vector<Violation> checkFiles(const fs::path& root)
{
    std::vector<Violation> violations;
    for (const SourceFile& file : sourcesBelow(root)) {
        const fs::path path(file.name);
        if (file.lines.empty() || file.lines.front() != licenceLine)
            violations.push_back({file.name, 1, "does not begin with \"" + std::string(licenceLine) + "\""});
        if (isHeader(path) && std::ranges::find(file.lines, "#pragma once"s) == file.lines.end())
            violations.push_back({file.name, 1, "is a header without #pragma once"});
        if (!isSnakeCase(path.stem().string()))
            violations.push_back({file.name, 1, "is not named in snake_case"});
        if (file.lines.size() > maxFileLines)
            violations.push_back({file.name, maxFileLines + 1,
                                  "has " + std::to_string(file.lines.size()) + " lines, more than " +
                                      std::to_string(maxFileLines) + "; split it"});
    }
    return violations;
}

std::vector<Violation> checkIncludes(const fs::path& root, const ModuleRules& rules)
{
    std::vector<Violation> violations;
    for (const SourceFile& file : sourcesBelow(root))
        IncludeCheck(file, rules, violations).run();
    return violations;
}

} // namespace agv::arch
