// Says in plain words where and why a value does not match its schema.
#pragma once
#include <string>
#include <vector>

#include "server/http/message.h"
#include "server/system/refusal.h"

namespace raywalk::http {

/// `node` itself, or what its `$ref` into `document` names.
const Json& resolved(const Json& document, const Json& node);

/// The field whose value tells the alternatives of `schema` apart (`discriminator`); empty: there is none.
std::string discriminator(const Json& schema);
/// The alternative (`anyOf`) that this field of the value names; null when it names none.
const Json* alternative_named(const Json& document, const Json& schema, const Json& value);

/// Every offence of `value` against `schema` with its JSON pointer, for the keywords that the contract uses; none where
/// it finds none. Of alternatives (`anyOf`) the one that the discriminator names counts, else the one that shares most
/// fields with the value: what its sender had in mind. A missing field is an offence of the object that lacks it.
std::vector<Refusal::Offence> explain(const Json& document, const Json& schema, const Json& value);

}  // namespace raywalk::http
