// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/Recipe.h"

#include "core/base/files/FileInUse.h"
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/recipe/RecipeJson.h"
#include "core/volume/SurfaceThreshold.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <set>

namespace core {

namespace {

Error placed(Error error, const char* list, int entry)
{
    const QString place = QStringLiteral("(%1 %2)").arg(QLatin1String(list)).arg(entry);
    if (givesNoReason(error.code))
        error.arguments.set(entryArgument, place);
    else if (error.arguments.size() < 2)
        error.arguments.append(place);
    else
        error.arguments.set(1, Clause::saying("%1 %2", error.arguments[1], place));
    return error;
}

/// The same error, saying where in the recipe it is.
tl::unexpected<Error> at(Error error, const char* list, int index)
{
    return tl::unexpected<Error>(placed(std::move(error), list, index + 1));
}

/// The place of a step in the recipe's file, from 1.
int entryOf(const Recipe& recipe, std::size_t step)
{
    return recipe.entries.empty() ? int(step) + 1 : recipe.entries[step];
}

Result<QJsonArray> takeList(QJsonObject& object, const char* name, bool required)
{
    const QJsonValue value = object.take(QLatin1String(name));
    if (value.isUndefined() && !required)
        return QJsonArray();
    if (!value.isArray())
        return failure(ErrorCode::InvalidField, QString(QLatin1String(name)),
            value.isUndefined() ? Clause::saying("missing") : Clause::saying("must be a list"));
    return value.toArray();
}

/// Puts a surface in where a cut names none. @return whether it did
bool completeSurface(QJsonValue& json)
{
    QJsonObject object = json.toObject();
    const QString name = object.value(QStringLiteral("edit")).toString();
    // What restores says as which tool.
    const QString tool =
        name == QLatin1String("restore") ? object.value(QStringLiteral("as")).toString() : name;
    if (!startsOnSurface(tool) || object.contains(QStringLiteral("surface")))
        return false;
    object.insert(QStringLiteral("surface"), QJsonObject{{QStringLiteral("threshold"), 0.0}});
    json = object;
    return true;
}

/// Whether nobody knows the segments that an edit adds before it is carried out.
bool areUnknown(AddedSegments added)
{
    switch (added) {
    case AddedSegments::None:
    case AddedSegments::Known:
        return false;
    case AddedSegments::UnknownPlane:
    case AddedSegments::UnknownNumber:
        return true;
    }
    return true;
}

/// What an edit adds to the document is last there.
void addFilled(std::set<int>& labels, const FilledSegments& filled, const Document& document,
    std::size_t segmentsBefore)
{
    for (std::size_t i = 0; i < document.segments.size(); ++i) {
        const Segment& segment = document.segments[i];
        if (filled.label == segment.label || filled.other == segment.label
            || (filled.added != AddedSegments::None && i >= segmentsBefore)
            || (!filled.name.isEmpty() && filled.name == segment.name))
            labels.insert(segment.label);
    }
}

} // namespace

Error atEdit(Error error, int entry)
{
    return placed(std::move(error), "edit", entry);
}

Result<Recipe> readRecipe(const QString& path)
{
    Result<QJsonObject> object = readRecipeJson(path);
    if (!object)
        return tl::unexpected(object.error());
    const Result<QJsonArray> edits = takeList(*object, "edits", true);
    if (!edits)
        return tl::unexpected(edits.error());
    const Result<QJsonArray> exports = takeList(*object, "export", false);
    if (!exports)
        return tl::unexpected(exports.error());
    Recipe recipe{
        .path = path, .study = {}, .steps = {}, .entries = {}, .withoutSurface = {}, .exports = {}};
    if (const QJsonValue study = object->take(QStringLiteral("study")); !study.isUndefined()) {
        recipe.study = SessionSource::fromJson(study.toObject());
        if (!recipe.study)
            return failure(ErrorCode::InvalidField, QStringLiteral("study"),
                Clause::saying("must be what \"burin history --as-recipe\" writes there"));
    }
    if (!object->isEmpty())
        return failure(ErrorCode::InvalidField, object->constBegin().key(),
            Clause::saying("unknown field of a recipe"));

    for (int i = 0; i < edits->size(); ++i) {
        QJsonValue json = (*edits)[i];
        if (completeSurface(json))
            recipe.withoutSurface.push_back(std::size_t(i));
        Result<RecipeStep> step = recipeStepFromJson(json);
        if (!step)
            return at(step.error(), "edit", i);
        recipe.steps.push_back(*std::move(step));
    }
    for (int i = 0; i < exports->size(); ++i) {
        const Result<RecipeExport> target = exportFromJson((*exports)[i]);
        if (!target)
            return at(target.error(), "export", i);
        recipe.exports.push_back(*target);
    }
    return recipe;
}

void fillSurfaces(Recipe& recipe, const Volume& volume)
{
    const double threshold = usualSurfaceThreshold(volume);
    for (const std::size_t step : recipe.withoutSurface)
        setSurface(std::get<Edit>(recipe.steps[step]), threshold);
}

Result<void> checkRecipe(const Recipe& recipe, Document document, bool replaceExisting)
{
    std::set<int> seeded;
    bool isUnknown = false; // what the document comes to
    for (std::size_t i = 0; i < recipe.steps.size() && !isUnknown; ++i) {
        const auto* edit = std::get_if<Edit>(&recipe.steps[i]);
        isUnknown = !edit;
        if (isUnknown)
            break;
        if (const Result<void> checked = checkAgainst(document, *edit); !checked)
            return tl::unexpected(atEdit(checked.error(), entryOf(recipe, i)));
        const std::size_t segmentsBefore = document.segments.size();
        static_cast<void>(applyToDocument(*edit, document));
        const FilledSegments filled = effectsOf(*edit).fills;
        isUnknown = areUnknown(filled.added);
        addFilled(seeded, filled, document, segmentsBefore);
    }
    const Volume& volume = document.volumes.front();
    std::vector<FileIdentity> files;
    for (std::size_t i = 0; i < recipe.exports.size(); ++i) {
        const RecipeExport& target = recipe.exports[i];
        if (const Result<void> checked = checkExportTarget(target, volume, replaceExisting);
            !checked)
            return checked;
        for (const QString& file : filesWritten(target)) {
            const std::optional<FileIdentity> identity = FileIdentity::of(file);
            if (identity && std::find(files.begin(), files.end(), *identity) != files.end())
                return at({ErrorCode::InvalidField,
                              {QStringLiteral("export.file"),
                                  Clause::saying("%1 is written twice", file)}},
                    "export", int(i));
            if (identity)
                files.push_back(*identity);
        }
        if (target.what == RecipeExport::What::Coverage && !isUnknown
            && !document.layer(target.layer))
            return at({ErrorCode::InvalidField,
                          {QStringLiteral("export.layer"),
                              Clause::saying("there is no sculpt layer %1", target.layer)}},
                "export", int(i));
        if (target.what != RecipeExport::What::Segments || !factsOf(target.format).isSeg
            || isUnknown)
            continue;
        for (const int label : seeded) {
            const Segment* segment = document.segment(label);
            if (segment && !segment->code.isSet())
                return failure(ErrorCode::SegmentNotCoded, segment->name);
        }
    }
    return {};
}

} // namespace core
