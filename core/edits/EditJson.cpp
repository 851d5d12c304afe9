// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"

#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "core/edits/schema/FieldVisitor.h"

#include <QJsonArray>
#include <QStringList>

#include <utility>

namespace core {

using editSchema::Presence;

namespace {

class Writer : public editSchema::FieldVisitor<Writer> {
public:
    template <class Kind>
    void field(
        const char* name, Presence, typename Kind::Value& value, const Kind& kind, const char*)
    {
        m_object.insert(QLatin1String(name), kind.write(value));
    }
    void constant(const char* name, Presence, const QJsonValue& value, const char*)
    {
        m_object.insert(QLatin1String(name), value);
    }
    template <class Inside> void group(const char* name, const char*, const Inside& visitInside)
    {
        Writer writer;
        visitInside(writer);
        m_object.insert(QLatin1String(name), writer.m_object);
    }
    QJsonObject m_object;
};

/// Takes fields out of an object; what is left over at the end is unknown. Keeps the first failure.
class Reader : public editSchema::FieldVisitor<Reader> {
public:
    Reader(QString path, QJsonObject object)
        : m_path(std::move(path))
        , m_object(std::move(object))
    {
    }

    template <class Kind>
    void field(const char* name, Presence presence, typename Kind::Value& value, const Kind& kind,
        const char*)
    {
        if (const std::optional<QJsonValue> json = take(name, presence))
            note(name, kind.read(*json, value));
    }
    template <class Kind>
    void maybe(const char* name, std::optional<typename Kind::Value>& value, const Kind& kind,
        const char*, const char* = nullptr)
    {
        if (const std::optional<QJsonValue> json = take(name, Presence::Optional))
            note(name, kind.read(*json, value.emplace()));
    }
    void constant(const char* name, Presence presence, const QJsonValue& only, const char*)
    {
        const std::optional<QJsonValue> json = take(name, presence);
        if (json && *json != only)
            note(name,
                Clause::saying("only %1 is supported",
                    only.isBool() ? QStringLiteral("true") : only.toString()));
    }
    template <class Inside> void group(const char* name, const char*, const Inside& visitInside)
    {
        const std::optional<QJsonValue> json = take(name, Presence::Required);
        if (!json)
            return;
        if (!json->isObject())
            return note(name, Clause::saying("must be an object"));
        Reader reader(pathOf(name), json->toObject());
        visitInside(reader);
        reader.refuseTheRest();
        if (!m_error)
            m_error = reader.m_error;
    }
    template <class Value, class Inside>
    void maybeGroup(const char* name, std::optional<Value>& value, const char* meaning, const char*,
        const Inside& visitInside)
    {
        if (m_object.contains(QLatin1String(name)))
            group(name, meaning, [&](Reader& inside) { visitInside(inside, value.emplace()); });
    }
    void refuseTheRest()
    {
        if (!m_object.isEmpty())
            noteAt(pathOf(m_object.constBegin().key()), Clause::saying("unknown field"));
    }
    const std::optional<Error>& error() const { return m_error; }

private:
    QString pathOf(const QString& name) const { return m_path + QLatin1Char('.') + name; }
    QString pathOf(const char* name) const { return pathOf(QString(QLatin1String(name))); }

    std::optional<QJsonValue> take(const char* name, Presence presence)
    {
        const auto found = m_object.find(QLatin1String(name));
        if (found == m_object.end()) {
            if (presence == Presence::Required)
                note(name, QStringLiteral("missing"));
            return {};
        }
        const QJsonValue value = *found;
        m_object.erase(found);
        return value;
    }
    void note(const char* name, const Clause& reason) { noteAt(pathOf(name), reason); }
    void noteAt(const QString& path, const Clause& reason)
    {
        if (!reason.isEmpty() && !m_error)
            m_error = Error{ErrorCode::InvalidField, {path, reason}};
    }

    QString m_path;
    QJsonObject m_object;
    std::optional<Error> m_error;
};

class Checker : public editSchema::FieldVisitor<Checker> {
public:
    Checker(QString path, bool atBegin)
        : m_path(std::move(path))
        , m_atBegin(atBegin)
    {
    }

    template <class Kind>
    void field(
        const char* name, Presence, typename Kind::Value& value, const Kind& kind, const char*)
    {
        if constexpr (std::is_same_v<Kind, editFields::SampleList>) {
            if (m_atBegin && value.empty())
                return;
        }
        note(name, kind.check(value));
    }
    template <class Inside> void group(const char* name, const char*, const Inside& visitInside)
    {
        Checker inside(m_path + QLatin1Char('.') + QLatin1String(name), m_atBegin);
        visitInside(inside);
        if (!m_error)
            m_error = inside.m_error;
    }
    const std::optional<Error>& error() const { return m_error; }

private:
    void note(const char* name, const Clause& reason)
    {
        if (!reason.isEmpty() && !m_error)
            m_error = Error{
                ErrorCode::InvalidField, {m_path + QLatin1Char('.') + QLatin1String(name), reason}};
    }

    QString m_path;
    bool m_atBegin = false;
    std::optional<Error> m_error;
};

Result<void> check(Edit edit, bool atBegin)
{
    return visitEdit(
        [atBegin](auto& fields) -> Result<void> {
            using E = std::decay_t<decltype(fields)>;
            Checker checker(QLatin1String(editSchema::editName<E>), atBegin);
            editSchema::visitFields(checker, fields);
            if (checker.error())
                return tl::unexpected(*checker.error());
            return {};
        },
        edit);
}

/// Fills @p edit if it is the one that is named so.
template <class E>
std::optional<Result<Edit>> readIfNamed(const QString& name, const QJsonObject& object)
{
    if (name != QLatin1String(editSchema::editName<E>))
        return {};
    E edit;
    Reader reader(name, object);
    editSchema::visitFields(reader, edit);
    reader.refuseTheRest();
    if (reader.error())
        return tl::unexpected(*reader.error());
    if (const Result<void> checked = check(edit, false); !checked)
        return tl::unexpected(checked.error());
    return Edit(std::move(edit));
}

template <class... Es> QStringList namesOf(EditKinds<Es...>)
{
    return {QString(QLatin1String(editSchema::editName<Es>))...};
}

template <class... Es>
Result<Edit> readAny(const QString& name, const QJsonObject& object, EditKinds<Es...> kinds)
{
    std::optional<Result<Edit>> result;
    static_cast<void>(((result = readIfNamed<Es>(name, object)) || ...));
    if (result)
        return *std::move(result);
    return failure(ErrorCode::UnknownEdit, name,
        Clause::saying("known are %1", namesOf(kinds).join(QStringLiteral(", "))));
}

Error notUnderstood(const QString& field, const Clause& reason)
{
    return {ErrorCode::InvalidField, {field, reason}};
}

/// {"edit": "restore", "as": "drill", …} is a drill that restores.
Result<QString> toolRestoredAs(QJsonObject& object)
{
    const QJsonValue as = object.take(QStringLiteral("as"));
    static const QStringList tools{QLatin1String(editSchema::editName<DrillStroke>),
        QLatin1String(editSchema::editName<LaserStroke>),
        QLatin1String(editSchema::editName<PeelCut>),
        QLatin1String(editSchema::editName<ScissorsCut>),
        QLatin1String(editSchema::editName<BrushStroke>)};
    if (!tools.contains(as.toString()))
        return tl::unexpected(notUnderstood(QStringLiteral("restore.as"),
            as.isUndefined() ? Clause::saying("missing")
                             : Clause::saying("must be %1", tools.join(QStringLiteral(" or ")))));
    if (!object.value(QStringLiteral("restore")).toBool(true))
        return tl::unexpected(
            notUnderstood(QStringLiteral("restore.restore"), Clause::saying("is never false")));
    object.insert(QStringLiteral("restore"), true);
    return as.toString();
}

/// What a peel or scissors may write instead of polygonMm: a mask as a drill has it, at the target.
Result<void> maskToPolygon(const QString& name, QJsonObject& object)
{
    constexpr double fineMm = 0.25;
    if (object.contains(QStringLiteral("polygonMm")))
        return tl::unexpected(notUnderstood(name + QStringLiteral(".mask"),
            Clause::saying("and polygonMm are two ways to say the same")));
    ToolMask mask;
    Reader reader(name, QJsonObject{{QStringLiteral("mask"), object.take(QStringLiteral("mask"))}});
    editSchema::visitMask(reader, mask);
    Checker checker(name, false);
    editSchema::visitMask(checker, mask);
    if (reader.error() || checker.error())
        return tl::unexpected(reader.error() ? *reader.error() : *checker.error());
    if (mask.softnessMm > 0.0)
        return tl::unexpected(notUnderstood(name + QStringLiteral(".mask.softnessMm"),
            Clause::saying("this tool has no soft edge")));
    QJsonArray polygon;
    for (const glm::dvec2& point : outlineMm(mask, fineMm))
        polygon.append(QJsonArray{point.x, point.y});
    object.insert(QStringLiteral("polygonMm"), polygon);
    return {};
}

} // namespace

QJsonObject editToJson(const Edit& edit)
{
    Edit copy = edit;
    Writer writer;
    visitEdit([&writer](auto& fields) { editSchema::visitFields(writer, fields); }, copy);
    writer.m_object.insert(QStringLiteral("edit"), editName(edit));
    return writer.m_object;
}

Result<Edit> editFromJson(const QJsonValue& json)
{
    if (!json.isObject())
        return failure(ErrorCode::InvalidField, QStringLiteral("edit"),
            Clause::saying("an edit must be an object"));
    QJsonObject object = json.toObject();
    const QJsonValue name = object.take(QStringLiteral("edit"));
    if (!name.isString())
        return failure(ErrorCode::InvalidField, QStringLiteral("edit"),
            name.isUndefined() ? Clause::saying("missing") : Clause::saying("must be a text"));
    QString known = name.toString();
    if (known == QLatin1String("restore")) {
        const Result<QString> tool = toolRestoredAs(object);
        if (!tool)
            return tl::unexpected(tool.error());
        known = *tool;
    }
    const bool outlined = known == QLatin1String(editSchema::editName<PeelCut>)
        || known == QLatin1String(editSchema::editName<ScissorsCut>);
    if (outlined && object.contains(QStringLiteral("mask"))) {
        if (const Result<void> told = maskToPolygon(known, object); !told)
            return tl::unexpected(told.error());
    }
    return readAny(known, object, AllEdits());
}

Result<void> checkFields(const Edit& edit)
{
    return check(edit, false);
}

Result<void> checkFieldsAtBegin(const Edit& edit)
{
    return check(edit, true);
}

QString editName(const Edit& edit)
{
    return visitEdit(
        [](const auto& fields) -> QString {
            return QLatin1String(editSchema::editName<std::decay_t<decltype(fields)>>);
        },
        edit);
}

} // namespace core
