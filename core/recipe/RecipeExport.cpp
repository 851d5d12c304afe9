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

tl::unexpected<Error> wrongField(const char* name, const QString& reason)
{
    return failure(
        ErrorCode::InvalidField, QStringLiteral("export.") + QLatin1String(name), reason);
}

Result<QString> takeText(QJsonObject& object, const char* name)
{
    const QJsonValue value = object.take(QLatin1String(name));
    if (!value.isString() || value.toString().isEmpty())
        return failure(ErrorCode::InvalidField, QStringLiteral("export.") + QLatin1String(name),
            value.isUndefined() ? QStringLiteral("missing") : QStringLiteral("must be a text"));
    return value.toString();
}

/// A flag that may be missing.
Result<bool> takeFlag(QJsonObject& object, const char* name)
{
    const QJsonValue value = object.take(QLatin1String(name));
    if (!value.isUndefined() && !value.isBool())
        return wrongField(name, QStringLiteral("must be true or false"));
    return value.toBool();
}

/// ["SCT", "24028007", "Right"]; nothing where there is none.
Result<CodedConcept> takeCode(QJsonObject& object, const char* name)
{
    CodedConcept code;
    const QJsonValue value = object.take(QLatin1String(name));
    if (value.isUndefined())
        return code;
    const QString problem = editFields::Code().read(value, code);
    if (!problem.isEmpty())
        return wrongField("codes", QStringLiteral("%1 %2").arg(QLatin1String(name), problem));
    return code;
}

/// {"Liver": {"category": […], "modifier": […], "region": […], "regionModifier": […]}, …}
Result<std::map<QString, SegCodes>> takeCodes(QJsonObject& object)
{
    std::map<QString, SegCodes> all;
    const QJsonValue value = object.take(QStringLiteral("codes"));
    if (!value.isUndefined() && !value.isObject())
        return wrongField("codes", QStringLiteral("must be an object, an entry a segment's name"));
    const QJsonObject entries = value.toObject();
    for (auto entry = entries.constBegin(); entry != entries.constEnd(); ++entry) {
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
                QStringLiteral("'%1' of '%2' is not known; known are category, modifier, region "
                               "and regionModifier")
                    .arg(fields.constBegin().key(), entry.key()));
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
        return wrongField("deidentify", QStringLiteral("must be true or an object"));
    QJsonObject fields = value.toObject();
    DeidentifyOptions options;
    const QJsonValue dates = fields.take(QStringLiteral("dates"));
    if (dates.isDouble()) {
        options.dates = DeidentifyOptions::Dates::Shift;
        options.shiftDays = dates.toInt();
        if (double(options.shiftDays) != dates.toDouble() || options.shiftDays == 0)
            return wrongField(
                "deidentify", QStringLiteral("dates are shifted by whole days, not by none"));
    } else if (dates == QLatin1String("keep")) {
        options.dates = DeidentifyOptions::Dates::Keep;
    } else if (!dates.isUndefined() && dates != QLatin1String("remove")) {
        return wrongField(
            "deidentify", QStringLiteral("dates must be \"remove\", \"keep\" or a number of days"));
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
            "deidentify", QStringLiteral("'%1' is not known").arg(fields.constBegin().key()));
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
    const QString algorithm =
        object.take(QStringLiteral("algorithm")).toString(QStringLiteral("semiautomatic"));
    if (algorithm == QLatin1String("manual"))
        settings.algorithm = SegAlgorithm::Manual;
    else if (algorithm == QLatin1String("automatic"))
        settings.algorithm = SegAlgorithm::Automatic;
    else if (algorithm != QLatin1String("semiautomatic"))
        return wrongField(
            "algorithm", QStringLiteral("must be \"manual\", \"semiautomatic\" or \"automatic\""));
    if (object.contains(QStringLiteral("algorithmName"))) {
        const Result<QString> name = takeText(object, "algorithmName");
        if (!name)
            return tl::unexpected(name.error());
        settings.algorithmName = *name;
    }
    return settings;
}

/// What a name says about what can be written there.
QString obstacleOf(const RecipeExport& target, const Volume& volume)
{
    const QString ending = QStringLiteral("the name of a NIfTI file ends in .nii or .nii.gz");
    switch (target.what) {
    case RecipeExport::What::Coverage:
        return isNiftiName(target.file) ? QString() : ending;
    case RecipeExport::What::CarvedVolume:
        return isNiftiName(target.file) ? QString() : carvedSeriesObstacle(volume);
    case RecipeExport::What::Segments:
        break;
    }
    if (factsOf(target.format).namesSourceImages) {
        if (const QString obstacle = dicomSegObstacle(volume); !obstacle.isEmpty())
            return obstacle;
    }
    return exportNameObstacle(target.format, target.file);
}

} // namespace

Result<RecipeExport> exportFromJson(const QJsonValue& json)
{
    if (!json.isObject())
        return failure(ErrorCode::InvalidField, QStringLiteral("export"),
            QStringLiteral("an export must be an object"));
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
            QStringLiteral("'%1' is not known; known are %2, coverage and carved-volume")
                .arg(*format, exportFormatNames().join(QStringLiteral(", "))));
    const Result<QString> file = takeText(object, "file");
    if (!file)
        return tl::unexpected(file.error());
    made.file = *file;
    if (made.what == RecipeExport::What::Coverage) {
        const QJsonValue layer = object.take(QStringLiteral("layer"));
        if (layer.toDouble() != layer.toInt() || layer.toInt() < 1)
            return failure(ErrorCode::InvalidField, QStringLiteral("export.layer"),
                layer.isUndefined() ? QStringLiteral("missing")
                                    : QStringLiteral("must be the number of a sculpt layer"));
        made.layer = layer.toInt();
    }
    if (made.what == RecipeExport::What::Segments && factsOf(made.format).isSeg) {
        const Result<SegSettings> seg = takeSegSettings(object);
        if (!seg)
            return tl::unexpected(seg.error());
        made.seg = *seg;
        Result<std::map<QString, SegCodes>> codes = takeCodes(object);
        if (!codes)
            return tl::unexpected(codes.error());
        made.codes = *std::move(codes);
    }
    if (made.what == RecipeExport::What::Segments && factsOf(made.format).isSurface) {
        const QString space = object.take(QStringLiteral("space")).toString(QStringLiteral("LPS"));
        if (space != QLatin1String("LPS") && space != QLatin1String("RAS"))
            return failure(ErrorCode::InvalidField, QStringLiteral("export.space"),
                QStringLiteral("must be \"LPS\" or \"RAS\""));
        made.space = space == QLatin1String("RAS") ? MeshSpace::Ras : MeshSpace::Lps;
    }
    if (made.what == RecipeExport::What::CarvedVolume) {
        const QJsonValue fill = object.take(QStringLiteral("fill"));
        if (!fill.isUndefined() && !fill.isDouble())
            return failure(ErrorCode::InvalidField, QStringLiteral("export.fill"),
                QStringLiteral("must be a number"));
        if (fill.isDouble())
            made.fill = fill.toDouble();
    }
    if (made.what != RecipeExport::What::Coverage) {
        if (const Result<void> taken = takeDeidentify(object, made); !taken)
            return tl::unexpected(taken.error());
    }
    if (!object.isEmpty())
        return failure(ErrorCode::InvalidField,
            QStringLiteral("export.") + object.constBegin().key(), QStringLiteral("unknown field"));
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
    if (const QString obstacle = obstacleOf(target, volume); !obstacle.isEmpty())
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
            folder.isDir() ? QStringLiteral("the folder cannot be written")
                           : QStringLiteral("there is no folder %1").arg(folder.filePath()));
    return {};
}

} // namespace core
