// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditDocumentation.h"

#include "core/edits/kinds/AnyEdit.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace core {

using editSchema::Presence;

namespace {

QString jsonText(const QJsonValue& value)
{
    // QJsonDocument writes objects and arrays only.
    const QByteArray list = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(list.mid(1, list.size() - 2));
}

class Describer {
public:
    Describer(QString prefix, std::vector<FieldDocumentation>& fields)
        : m_prefix(std::move(prefix))
        , m_fields(fields)
    {
    }

    template <class Kind>
    void field(const char* name, Presence presence, typename Kind::Value& value, const Kind& kind,
        const char* meaning)
    {
        const bool required = presence == Presence::Required;
        add(name, kind.type(), kind.unit(), required ? QString() : jsonText(kind.write(value)),
            meaning);
    }
    template <class Kind>
    void maybe(const char* name, std::optional<typename Kind::Value>&, const Kind& kind,
        const char* meaning, const char* absent = "unchanged")
    {
        add(name, kind.type(), kind.unit(), QLatin1String(absent), meaning);
    }
    void constant(const char* name, Presence presence, const QJsonValue& value, const char* meaning)
    {
        const QString text = jsonText(value);
        add(name, text, {}, presence == Presence::Required ? QString() : text, meaning);
    }
    template <class Inside>
    void group(const char* name, const char* meaning, const Inside& visitInside)
    {
        add(name, QStringLiteral("object"), {}, {}, meaning);
        Describer inside(m_prefix + QLatin1String(name) + QLatin1Char('.'), m_fields);
        visitInside(inside);
    }

    template <class Value, class Inside>
    void maybeGroup(const char* name, std::optional<Value>&, const char* meaning,
        const char* absent, const Inside& visitInside)
    {
        add(name, QStringLiteral("object"), {}, QLatin1String(absent), meaning);
        Describer inside(m_prefix + QLatin1String(name) + QLatin1Char('.'), m_fields);
        Value some;
        visitInside(inside, some);
    }

    template <class Inside> void when(bool, const Inside& visitInside) { visitInside(); }

private:
    void add(const char* name, const QString& type, const QString& unit, const QString& fallback,
        const char* meaning)
    {
        m_fields.push_back({.name = m_prefix + QLatin1String(name),
            .type = type,
            .unit = unit,
            .fallback = fallback,
            .meaning = QString::fromUtf8(meaning)});
    }

    QString m_prefix;
    std::vector<FieldDocumentation>& m_fields;
};

template <class E> EditDocumentation document()
{
    static_assert(editSchema::editName<E> && editSchema::editMeaning<E>,
        "an edit X needs editName<X> and editMeaning<X> in the schema of its family");
    EditDocumentation result;
    result.name = QLatin1String(editSchema::editName<E>);
    result.meaning = QString::fromUtf8(editSchema::editMeaning<E>);
    E edit;
    Describer describer({}, result.fields);
    editSchema::visitFields(describer, edit);
    return result;
}

template <class... Es> std::vector<EditDocumentation> documentAll(EditKinds<Es...>)
{
    return {document<Es>()...};
}

} // namespace

std::vector<EditDocumentation> editDocumentation()
{
    return documentAll(AllEdits());
}

} // namespace core
