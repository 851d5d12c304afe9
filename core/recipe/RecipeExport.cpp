// SPDX-License-Identifier: Apache-2.0
#include "core/recipe/RecipeExport.h"

#include "core/base/files/StagedFile.h"
#include "core/edits/fields/EditFields.h"
#include "core/export/CarvedVolume.h"
#include "core/export/common/StatisticsText.h"
#include "core/nifti/NiftiReader.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonObject>

namespace core {

namespace {

tl::unexpected<Error> wrongField(const char* name, const Clause& reason)
{
    return failure(
        ErrorCode::InvalidField, QStringLiteral("export.") + QLatin1String(name), reason);
}

Result<QString> takeText(QJsonObject& object, const char* name)
{
    const QJsonValue value = object.take(QLatin1String(name));
    if (!value.isString() || value.toString().isEmpty())
        return failure(ErrorCode::InvalidField, QStringLiteral("export.") + QLatin1String(name),
            value.isUndefined() ? Clause::saying("missing") : Clause::saying("must be a text"));
    return value.toString();
}

/// One of some words, or the usual one where there is none; the caller tells which words there are.
/// What is no text is none of them.
QString takeWord(QJsonObject& object, const char* name, const char* usual)
{
    const QJsonValue value = object.take(QLatin1String(name));
    return value.isUndefined() ? QString(QLatin1String(usual)) : value.toString();
}

/// A flag that may be missing.
Result<bool> takeFlag(QJsonObject& object, const char* name)
{
    const QJsonValue value = object.take(QLatin1String(name));
    if (!value.isUndefined() && !value.isBool())
        return wrongField(name, Clause::saying("must be true or false"));
    return value.toBool();
}

/// ["SCT", "24028007", "Right"]; nothing where there is none.
Result<CodedConcept> takeCode(QJsonObject& object, const char* name)
{
    CodedConcept code;
    const QJsonValue value = object.take(QLatin1String(name));
    if (value.isUndefined())
        return code;
    const Clause problem = editFields::Code().read(value, code);
    if (!problem.isEmpty())
        return wrongField("codes", Clause::saying("%1 %2", QLatin1String(name), problem));
    return code;
}

/// {"Liver": {"category": […], "modifier": […], "region": […], "regionModifier": […]}, …}
Result<std::map<QString, SegCodes>> takeCodes(QJsonObject& object)
{
    std::map<QString, SegCodes> all;
    const QJsonValue value = object.take(QStringLiteral("codes"));
    if (!value.isUndefined() && !value.isObject())
        return wrongField("codes", Clause::saying("must be an object, an entry a segment's name"));
    const QJsonObject entries = value.toObject();
    for (auto entry = entries.constBegin(); entry != entries.constEnd(); ++entry) {
        if (!entry->isObject())
            return wrongField("codes",
                Clause::saying("'%1' must be an object with category, modifier, region or "
                               "regionModifier",
                    entry.key()));
        QJsonObject fields = entry->toObject();
        SegCodes& codes = all[entry.key()];
        for (const auto& [name, target] : {std::pair("category", &codes.category),
                 std::pair("modifier", &codes.modifier), std::pair("region", &codes.region),
                 std::pair("regionModifier", &codes.regionModifier)}) {
            const Result<CodedConcept> code = takeCode(fields, name);
            if (!code)
                return tl::unexpected(code.error());
            *target = *code;
        }
        if (!fields.isEmpty())
            return wrongField("codes",
                Clause::saying("'%1' of '%2' is not known; known are category, modifier, region "
                               "and regionModifier",
                    fields.constBegin().key(), entry.key()));
    }
    return all;
}

/// true, or {"dates": "remove", "keep" or days to shift by, "keepDevice", "keepDescriptions",
/// "secret"}.
Result<void> takeDeidentify(QJsonObject& object, RecipeExport& made)
{
    const QJsonValue value = object.take(QStringLiteral("deidentify"));
    if (value.isUndefined() || value == QJsonValue(false))
        return {};
    if (!value.isBool() && !value.isObject())
        return wrongField("deidentify", Clause::saying("must be true or an object"));
    QJsonObject fields = value.toObject();
    DeidentifyOptions options;
    const QJsonValue dates = fields.take(QStringLiteral("dates"));
    if (dates.isDouble()) {
        options.dates = DeidentifyOptions::Dates::Shift;
        options.shiftDays = dates.toInt();
        if (double(options.shiftDays) != dates.toDouble() || options.shiftDays == 0)
            return wrongField(
                "deidentify", Clause::saying("dates are shifted by whole days, not by none"));
    } else if (dates == QLatin1String("keep")) {
        options.dates = DeidentifyOptions::Dates::Keep;
    } else if (!dates.isUndefined() && dates != QLatin1String("remove")) {
        return wrongField(
            "deidentify", Clause::saying("dates must be \"remove\", \"keep\" or a number of days"));
    }
    const Result<bool> device = takeFlag(fields, "keepDevice");
    if (!device)
        return tl::unexpected(device.error());
    options.keepDevice = *device;
    const Result<bool> descriptions = takeFlag(fields, "keepDescriptions");
    if (!descriptions)
        return tl::unexpected(descriptions.error());
    options.keepDescriptions = *descriptions;
    if (fields.contains(QStringLiteral("secret"))) {
        const Result<QString> secret = takeText(fields, "secret");
        if (!secret)
            return tl::unexpected(secret.error());
        made.secret = secret->toUtf8();
    }
    if (!fields.isEmpty())
        return wrongField(
            "deidentify", Clause::saying("'%1' is not known", fields.constBegin().key()));
    made.deidentify = options;
    return {};
}

Result<SegSettings> takeSegSettings(QJsonObject& object)
{
    SegSettings settings;
    const Result<bool> deflated = takeFlag(object, "deflated");
    if (!deflated)
        return tl::unexpected(deflated.error());
    settings.deflated = *deflated;
    const QString algorithm = takeWord(object, "algorithm", "semiautomatic");
    if (algorithm == QLatin1String("manual"))
        settings.algorithm = SegAlgorithm::Manual;
    else if (algorithm == QLatin1String("automatic"))
        settings.algorithm = SegAlgorithm::Automatic;
    else if (algorithm != QLatin1String("semiautomatic"))
        return wrongField(
            "algorithm", Clause::saying("must be \"manual\", \"semiautomatic\" or \"automatic\""));
    if (object.contains(QStringLiteral("algorithmName"))) {
        const Result<QString> name = takeText(object, "algorithmName");
        if (!name)
            return tl::unexpected(name.error());
        settings.algorithmName = *name;
    }
    return settings;
}

/// What a name says about what can be written there.
Clause obstacleOf(const RecipeExport& target, const Volume& volume)
{
    const Clause ending = Clause::saying("the name of a NIfTI file ends in .nii or .nii.gz");
    switch (target.what) {
    case RecipeExport::What::Coverage:
        return isNiftiName(target.file) ? Clause() : ending;
    case RecipeExport::What::CarvedVolume:
        return isNiftiName(target.file) ? Clause() : carvedSeriesObstacle(volume);
    case RecipeExport::What::Segments:
        break;
    }
    if (factsOf(target.format).namesSourceImages) {
        if (const Clause obstacle = dicomSegObstacle(volume); !obstacle.isEmpty())
            return obstacle;
    }
    return exportNameObstacle(target.format, target.file);
}

} // namespace

Result<RecipeExport> exportFromJson(const QJsonValue& json)
{
    if (!json.isObject())
        return failure(ErrorCode::InvalidField, QStringLiteral("export"),
            Clause::saying("an export must be an object"));
    QJsonObject object = json.toObject();
    const Result<QString> format = takeText(object, "format");
    if (!format)
        return tl::unexpected(format.error());
    const std::optional<ExportFormat> known = exportFormatNamed(*format);
    RecipeExport made;
    if (known)
        made.format = *known;
    else if (*format == QLatin1String("coverage"))
        made.what = RecipeExport::What::Coverage;
    else if (*format == QLatin1String("carved-volume"))
        made.what = RecipeExport::What::CarvedVolume;
    else
        return failure(ErrorCode::InvalidField, QStringLiteral("export.format"),
            Clause::saying("'%1' is not known; known are %2, coverage and carved-volume", *format,
                exportFormatNames().join(QStringLiteral(", "))));
    const Result<QString> file = takeText(object, "file");
    if (!file)
        return tl::unexpected(file.error());
    made.file = *file;
    if (made.what == RecipeExport::What::Coverage) {
        const QJsonValue layer = object.take(QStringLiteral("layer"));
        if (layer.toDouble() != layer.toInt() || layer.toInt() < 1)
            return failure(ErrorCode::InvalidField, QStringLiteral("export.layer"),
                layer.isUndefined() ? Clause::saying("missing")
                                    : Clause::saying("must be the number of a sculpt layer"));
        made.layer = layer.toInt();
    }
    if (made.what == RecipeExport::What::Segments && factsOf(made.format).isSeg) {
        const Result<SegSettings> seg = takeSegSettings(object);
        if (!seg)
            return tl::unexpected(seg.error());
        made.seg = *seg;
    }
    if (made.what == RecipeExport::What::Segments && factsOf(made.format).holdsCodes) {
        Result<std::map<QString, SegCodes>> codes = takeCodes(object);
        if (!codes)
            return tl::unexpected(codes.error());
        made.codes = *std::move(codes);
    }
    if (made.what == RecipeExport::What::Segments && factsOf(made.format).isSurface) {
        const QString space = takeWord(object, "space", "LPS");
        if (space != QLatin1String("LPS") && space != QLatin1String("RAS"))
            return failure(ErrorCode::InvalidField, QStringLiteral("export.space"),
                Clause::saying("must be \"LPS\" or \"RAS\""));
        made.space = space == QLatin1String("RAS") ? MeshSpace::Ras : MeshSpace::Lps;
    }
    if (made.what == RecipeExport::What::CarvedVolume) {
        const QJsonValue fill = object.take(QStringLiteral("fill"));
        if (!fill.isUndefined() && !fill.isDouble())
            return failure(ErrorCode::InvalidField, QStringLiteral("export.fill"),
                Clause::saying("must be a number"));
        if (fill.isDouble())
            made.fill = fill.toDouble();
    }
    if (made.what != RecipeExport::What::Coverage) {
        if (const Result<void> taken = takeDeidentify(object, made); !taken)
            return tl::unexpected(taken.error());
    }
    if (!object.isEmpty())
        return failure(ErrorCode::InvalidField,
            QStringLiteral("export.") + object.constBegin().key(), Clause::saying("unknown field"));
    return made;
}

QStringList filesWritten(const RecipeExport& target)
{
    QStringList files{target.file};
    if (target.what == RecipeExport::What::Segments && target.format == ExportFormat::Sr)
        files += segBeside(target.file);
    return files;
}

Result<void> checkExportTarget(
    const RecipeExport& target, const Volume& volume, bool replaceExisting)
{
    const QFileInfo info(target.file);
    if (const Clause obstacle = obstacleOf(target, volume); !obstacle.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, target.file, obstacle);
    const bool series =
        target.what == RecipeExport::What::CarvedVolume && !isNiftiName(target.file);
    if (series && info.exists() && !(info.isDir() && QDir(target.file).isEmpty()))
        return failure(ErrorCode::FileExists, target.file); // a folder is never replaced
    for (const QString& file : series ? QStringList() : filesWritten(target)) {
        if (const Result<void> checked = checkFileTarget(file, replaceExisting); !checked)
            return checked;
    }
    const QFileInfo folder(info.absolutePath());
    if (!folder.isDir() || !folder.isWritable())
        return failure(ErrorCode::FileUnwritable, target.file,
            folder.isDir() ? Clause::saying("the folder cannot be written")
                           : Clause::saying("there is no folder %1", folder.filePath()));
    return {};
}

} // namespace core
