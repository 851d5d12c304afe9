// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditNames.h"

#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/FieldRoles.h"
#include "core/edits/kinds/FileKinds.h"
#include "core/edits/schema/FieldVisitor.h"

#include <QJsonArray>
#include <QJsonObject>

#include <cstddef>
#include <type_traits>

namespace core {

using editSchema::Presence;

namespace {

template <class E>
concept saysRowUse = requires
{
    static_cast<RowUse (*)(const E&)>(&rowUse);
};

/// Shows every row that an edit of kind E names.
template <class E> class RowVisitor : public editSchema::FieldVisitor<RowVisitor<E>> {
public:
    explicit RowVisitor(const std::function<void(std::int64_t&)>& take)
        : m_take(take)
    {
    }
    template <class Kind>
    void field(const char*, Presence, typename Kind::Value& value, const Kind&, const char*)
    {
        if constexpr (fieldRole<Kind>() == FieldRole::Row) {
            static_assert(saysRowUse<E>, "an edit X that names rows needs RowUse rowUse(const X&)");
            take(value);
        }
    }

private:
    void take(std::int64_t& row) { m_take(row); }
    void take(std::vector<std::int64_t>& rows)
    {
        for (std::int64_t& row : rows)
            m_take(row);
    }

    const std::function<void(std::int64_t&)>& m_take;
};

/// Shows every file that an edit of kind E names.
template <class E> class FileVisitor : public editSchema::FieldVisitor<FileVisitor<E>> {
public:
    explicit FileVisitor(const std::function<void(QString&)>& take)
        : m_take(take)
    {
    }
    template <class Kind>
    void field(const char*, Presence, typename Kind::Value& value, const Kind&, const char*)
    {
        if constexpr (fieldRole<Kind>() == FieldRole::File) {
            static_assert(isFileKind<E>, "an edit that names a file belongs to FileKinds");
            m_take(value);
        }
    }

private:
    const std::function<void(QString&)>& m_take;
};

/// Types of fields whose text is a word of the program, or voxels. Any other may hold what people
/// wrote.
template <class Kind>
inline constexpr bool isOwnWord =
    isOneOf<Kind, editFields::Colour, editFields::StepCount, editFields::PackedBytes>;
template <class E, std::size_t N> inline constexpr bool isOwnWord<editFields::Choice<E, N>> = true;

/// Collects the texts of an edit.
class TextVisitor : public editSchema::FieldVisitor<TextVisitor> {
public:
    template <class Kind>
    void field(const char*, Presence, typename Kind::Value& value, const Kind& kind, const char*)
    {
        if constexpr (!isOwnWord<Kind>)
            take(kind.write(value));
    }
    [[nodiscard]] const QStringList& texts() const { return m_texts; }

private:
    void take(const QJsonValue& json)
    {
        if (json.isString())
            m_texts.append(json.toString());
        const QJsonArray list = json.toArray();
        for (const QJsonValue& each : list)
            take(each);
        const QJsonObject object = json.toObject();
        for (auto each = object.begin(); each != object.end(); ++each) {
            // In voxels in base 64 and in the digits of a colour any short word can stand by
            // chance.
            if (each.key() != QLatin1String("voxels") && each.key() != QLatin1String("color"))
                take(each.value());
        }
    }

    QStringList m_texts;
};

} // namespace

RowUse rowUseOf(const Edit& edit)
{
    return visitEdit(
        [](const auto& known) {
            if constexpr (saysRowUse<std::decay_t<decltype(known)>>)
                return rowUse(known);
            else
                return RowUse::None;
        },
        edit);
}

void changeRowsNamed(Edit& edit, const std::function<void(std::int64_t&)>& change)
{
    visitEdit(
        [&change](auto& known) {
            RowVisitor<std::decay_t<decltype(known)>> visitor(change);
            editSchema::visitFields(visitor, known);
        },
        edit);
}

NamedRows rowsNamedBy(const Edit& edit)
{
    NamedRows named{.use = rowUseOf(edit)};
    if (named.use == RowUse::None)
        return named;
    Edit copy = edit; // visitors of fields may change them
    changeRowsNamed(copy, [&named](std::int64_t& row) { named.rows.push_back(row); });
    return named;
}

std::vector<std::int64_t> rowsTakenBackBy(const Edit& edit)
{
    if (rowUseOf(edit) != RowUse::TakesBack)
        return {};
    return rowsNamedBy(edit).rows;
}

void changeFilesNamed(Edit& edit, const std::function<void(QString&)>& change)
{
    visitEdit(
        [&change](auto& known) {
            FileVisitor<std::decay_t<decltype(known)>> visitor(change);
            editSchema::visitFields(visitor, known);
        },
        edit);
}

QStringList textsIn(const Edit& edit)
{
    Edit copy = edit; // visitors of fields may change them
    TextVisitor visitor;
    visitEdit([&visitor](auto& known) { editSchema::visitFields(visitor, known); }, copy);
    return visitor.texts();
}

} // namespace core
