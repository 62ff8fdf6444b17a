#include "src/parse_formula.hpp"

#include "hawser/deck/diagnostics.hpp"
#include "hawser/deck/spec_reader.hpp"
#include "src/formula_tokens.hpp"

namespace hawser {
namespace {

using Operation = Formula::Operation;
using Kind = FormulaToken::Kind;

/// Of two operands; those of one level are worked out from left to right.
struct Operator {
  const char* symbol;
  int level;
  Operation operation;
};
constexpr Operator operators[] = {
    {"||", 1, Operation::either},  {"&&", 2, Operation::both},    {"<", 3, Operation::less},
    {">", 3, Operation::greater},  {"<=", 3, Operation::at_most}, {">=", 3, Operation::at_least},
    {"==", 3, Operation::equal},   {"!=", 3, Operation::unequal}, {"+", 4, Operation::add},
    {"-", 4, Operation::subtract}, {"*", 5, Operation::multiply}, {"/", 5, Operation::divide}};

/// choice := operation [? choice : choice]; operands are signed powers; ^ binds stronger than the
/// sign before it and weaker than one after it: -2^2 = -4, 2^-2 = 0.25, 2^3^2 = 2^9.
class Parser {
 public:
  Parser(const std::string& text, const NamedValues* names, Formula& result, FieldNames* fields)
      : tokens_(text, names, fields), formula_(result), fields_(fields) {}

  void read() {
    int values = 1;
    choice();
    for (; tokens_.at(","); ++values) {
      tokens_.next();
      choice();
    }
    if (tokens_.now().kind != Kind::end) tokens_.refuse();
    if (values > 1)
      throw FormulaFault{"one value is needed, but ',' makes it " + std::to_string(values) +
                         "; components are separated by ';'"};
  }

 private:
  static constexpr const char* no_alternative = "'?' needs its ':'";

  void append(const Formula::Step& step) {
    formula_.append(step);
    if (formula_.depth() > Formula::deepest) too_long();
  }
  [[noreturn]] static void too_long() { throw FormulaFault{"the expression is too long"}; }

  void choice() {
    if (++nesting_ > 200) too_long();
    operation(1);
    if (tokens_.at("?")) {
      tokens_.next();
      choice();
      if (tokens_.at(")") || tokens_.at(",")) throw FormulaFault{no_alternative};
      if (!tokens_.at(":")) expect_end(no_alternative);
      tokens_.next();
      choice();
      append({Operation::choose, 3});
    }
    --nesting_;
  }

  void operation(int least_level) {
    operand();
    while (const Operator* const found = operator_now()) {
      if (found->level < least_level) return;
      tokens_.next();
      operation(found->level + 1);
      append({found->operation, 2});
    }
  }

  const Operator* operator_now() const {
    for (const Operator& candidate : operators)
      if (tokens_.at(candidate.symbol)) return &candidate;
    return nullptr;
  }

  void operand() {
    const bool minus = tokens_.at("-");
    if (minus || tokens_.at("+")) tokens_.next();
    primary();
    if (tokens_.at("^")) {
      if (++nesting_ > 200) too_long();
      tokens_.next();
      operand();
      formula_.append_power();
      --nesting_;
    }
    if (minus) append({Operation::negate, 1});
  }

  void primary() {
    const FormulaToken token = tokens_.now();
    if (token.kind == Kind::end || (token.kind == Kind::symbol && token.text != "("))
      tokens_.refuse();
    tokens_.next();
    if (token.kind == Kind::number) {
      append({Operation::number, 0, token.number});
    } else if (token.kind == Kind::variable) {
      append({Operation::variable, 0, 0, token.variable});
    } else if (token.kind == Kind::function) {
      call(*token.function);
    } else if (token.kind == Kind::field) {
      refer(token.text, -1);
    } else if (token.kind == Kind::derivative) {
      tokens_.next();  // past the parenthesis
      const FormulaToken field = tokens_.now();
      tokens_.next();
      if (field.kind != Kind::field || !tokens_.at(")"))
        throw FormulaFault{quoted(token.text) + " takes the name of a field, such as " +
                           token.text + "(temperature) or " + token.text + "(velocity_x)"};
      tokens_.next();
      refer(field.text, token.text[1] - 'x');
    } else {
      choice();
      close();
    }
  }

  void refer(const std::string& name, int along) {
    append({Operation::reference, 0, double(fields_->index(name, along))});
  }

  void call(const FormulaFunction& function) {
    const auto fault = [&](const char* amount) {
      throw FormulaFault{std::string("too ") + amount + " arguments for the function '" +
                         function.name + "'"};
    };
    int count = 0;
    do {
      tokens_.next();  // past the parenthesis or the comma
      if (count == 0 && tokens_.at(")")) break;
      choice();
      ++count;
    } while (tokens_.at(","));
    close();
    if (count < function.least) fault("few");
    if (count > function.most) fault("many");
    const auto kind = function.value != nullptr ? Operation::function_of_one : Operation::function;
    append({kind, count, 0, nullptr, &function});
  }

  void close() {
    if (!tokens_.at(")")) expect_end("a closing parenthesis is missing");
    tokens_.next();
  }
  /// At the end `fault` is what is missing; elsewhere it is the token that is wrong.
  void expect_end(const char* fault) {
    if (tokens_.now().kind == Kind::end) throw FormulaFault{fault};
    tokens_.refuse();
  }

  FormulaTokens tokens_;
  Formula& formula_;
  FieldNames* fields_;  // null: none are allowed
  int nesting_ = 0;
};

}  // namespace

std::string parse_formula(const std::string& text, const NamedValues* names, Formula& result,
                          FieldNames* fields) {
  if (trimmed(text).empty()) return "the expression is empty";
  try {
    Parser(text, names, result, fields).read();
  } catch (const FormulaFault& fault) {
    return fault.sentence;
  }
  return "";
}

}  // namespace hawser
