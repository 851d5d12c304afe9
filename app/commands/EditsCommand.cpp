// SPDX-License-Identifier: Apache-2.0
#include "app/commands/EditsCommand.h"

#include "app/steps/Arguments.h"
#include "core/recipe/RecipeStep.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cstdio>

namespace app {

namespace {

void printText(const std::vector<core::EditDocumentation>& edits)
{
    std::printf(
        "A recipe is {\"edits\": [edit, …], \"export\": [export, …]}. An export is one of\n"
        "{\"format\": \"dicom-seg\", \"dicom-seg-fractional\" or \"dicom-seg-labelmap\", \"file\": "
        "path, \"deflated\": true or false,\n \"algorithm\": \"manual\", \"semiautomatic\" or "
        "\"automatic\", \"algorithmName\": text, \"codes\": {name: …}},\n"
        "{\"format\": \"rtstruct\", \"nifti\", \"seg-nrrd\", \"csv\", \"json\" or \"sr\", "
        "\"file\": path; of seg-nrrd also \"codes\"},\n"
        "{\"format\": \"stl\", \"obj\", \"ply\" or \"gltf\", \"file\": path, \"space\": \"LPS\" "
        "or \"RAS\" (default: LPS)},\n"
        "{\"format\": \"coverage\", \"layer\": number, \"file\": path.nii.gz},\n"
        "{\"format\": \"carved-volume\", \"file\": path.nii.gz or a new folder for a DICOM "
        "series,\n \"fill\": value where nothing is left (default: the least)}.\n"
        "All but coverage take \"deidentify\": true or {\"dates\": …, …}; the help on export lists "
        "what it keeps.\n"
        "Each edit is an object {\"edit\": name, fields …}; any other field is refused.\n");
    for (const core::EditDocumentation& edit : edits) {
        std::printf("\n%s\n    %s\n\n", qPrintable(edit.name), qPrintable(edit.meaning));
        qsizetype nameWidth = 0;
        qsizetype typeWidth = 0;
        for (const core::FieldDocumentation& field : edit.fields) {
            nameWidth = std::max(nameWidth, field.name.size());
            typeWidth = std::max(typeWidth, field.type.size());
        }
        for (const core::FieldDocumentation& field : edit.fields) {
            QString line = field.meaning;
            if (!field.unit.isEmpty())
                line += QStringLiteral(" [%1]").arg(field.unit);
            if (!field.fallback.isEmpty())
                line += QStringLiteral(" (default: %1)").arg(field.fallback);
            std::printf("    %s  %s  %s\n", qPrintable(field.name.leftJustified(nameWidth)),
                qPrintable(field.type.leftJustified(typeWidth)), qPrintable(line));
        }
    }
}

void printJson(const std::vector<core::EditDocumentation>& edits)
{
    QJsonArray list;
    for (const core::EditDocumentation& edit : edits) {
        QJsonArray fields;
        for (const core::FieldDocumentation& field : edit.fields) {
            fields.append(QJsonObject{
                {QStringLiteral("name"), field.name},
                {QStringLiteral("type"), field.type},
                {QStringLiteral("unit"), field.unit},
                {QStringLiteral("required"), field.fallback.isEmpty()},
                {QStringLiteral("default"), field.fallback},
                {QStringLiteral("meaning"), field.meaning},
            });
        }
        list.append(QJsonObject{
            {QStringLiteral("edit"), edit.name},
            {QStringLiteral("meaning"), edit.meaning},
            {QStringLiteral("fields"), fields},
        });
    }
    std::fputs(QJsonDocument(list).toJson().constData(), stdout);
}

int runEdits(const Arguments& arguments)
{
    if (!arguments.rest().isEmpty())
        return reportUsageError(
            "edits", QStringLiteral("unknown argument '%1'").arg(arguments.rest().first()));
    (arguments.has("json") ? printJson : printText)(core::recipeStepDocumentation());
    return 0;
}

} // namespace

const Command editsCommand{.name = "edits",
    .words = "",
    .usage = "[--json]",
    .summary = "lists what a recipe can hold: every edit with its fields",
    .options = {{"json", nullptr, "prints it as JSON"}},
    .run = runEdits};

} // namespace app
