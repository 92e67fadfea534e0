// The contract at run time: the operations of openapi.yaml, each with the validators of its request.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/validator.h"

namespace raywalk::http {

enum class BodyKind { none, json, bytes, file };

struct Parameter {
  std::string name;
  bool is_number = false;  // integer or number
  bool required = false;
};

/// One operation: what its request may hold.
struct Operation {
  std::string id;
  std::string method;  // upper case
  std::string pattern;
  BodyKind body = BodyKind::none;
  std::string media_type;            // of the body
  std::vector<std::string> answers;  // media types of the 200 answer
  std::vector<Parameter> query;
  std::optional<Validator> path_check, query_check, header_check, body_check;
  std::vector<Parameter> headers;
};

class Contract {
 public:
  /// Throws std::runtime_error if the document is not the contract that it should be.
  explicit Contract(std::string_view openapi_json);

  const std::string& text() const { return text_; }
  const std::vector<Operation>& operations() const { return operations_; }
  /// The validator of one of the component schemas; for tests and for the proto examples.
  Validator schema(const std::string& name) const;

 private:
  std::string text_;
  Json document_;
  std::vector<Operation> operations_;
};

/// The contract that was embedded when the daemon was built (proto/openapi.yaml as JSON).
std::string_view embedded_contract();

/// Parameters given as text become typed JSON. Throws ApiError 400 invalid_parameter with `?name` pointers for the
/// query, and `name` in the detail for path and headers.
void check_path(const Operation& operation, const std::map<std::string, std::string>& given);
Json check_query(const Operation& operation, const std::multimap<std::string, std::string>& given);
void check_headers(const Operation& operation, const std::map<std::string, std::string>& given);
/// Throws ApiError 422 invalid_request.
Json check_body(const Operation& operation, std::string_view text);

}  // namespace raywalk::http
