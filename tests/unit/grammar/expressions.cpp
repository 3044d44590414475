#include "tests/support/catch.h"
#include "tests/unit/grammar/dump.h"

using durer::test::diagnose;
using durer::test::dump;
using durer::test::Parsed;
namespace ast = durer::ast;

TEST_CASE("expressions: products bind tighter than sums, both to the left",
          "[grammar][expressions]") {
  CHECK(dump("1-2-3") == "(- (- 1 2) 3)");
  CHECK(dump("1+2*3/4") == "(+ 1 (/ (* 2 3) 4))");
  CHECK(dump("(1+2)*3") == "(* ((+ 1 2)) 3)");
}

TEST_CASE("expressions: prefixes bind looser than components", "[grammar][expressions]") {
  CHECK(dump("-A.y") == "(neg A.y)");
  CHECK(dump("--2") == "(neg (neg 2))");
  CHECK(dump("+A") == "(pos A)");
  CHECK(dump("2*-3") == "(* 2 (neg 3))");
  CHECK(dump("-2*3") == "(* (neg 2) 3)");
  CHECK(dump("(!a=b)") == "((= (! a) b))");
  CHECK(dump("!<1,0,2>") == "(! <1 0 2>)");
}

TEST_CASE("expressions: components follow any primary, once", "[grammar][expressions]") {
  CHECK(dump("(A+B).z V().y <1,2,3>.x A[1].red trace(O,x,y).gray") ==
        "((+ A B)).z V().y <1 2 3>.x A[1].red trace(O x y).gray");
  CHECK(diagnose("A.x.y").substr(0, 5) == "D0101");
}

TEST_CASE("expressions: relations and logic are left-associative, logic has one precedence",
          "[grammar][expressions]") {
  CHECK(dump("(1|0&0)") == "((& (| 1 0) 0))");
  CHECK(dump("(1<2<3)") == "((< (< 1 2) 3))");
  CHECK(dump("(a+1<b*2 & c)") == "((& (< (+ a 1) (* b 2)) c))");
}

TEST_CASE("expressions: `?:` chains to the right", "[grammar][expressions]") {
  CHECK(dump("(a ? 1 : 2)") == "((? a 1 2))");
  CHECK(dump("(a ? b ? 1 : 2 : c ? 3 : 4)") == "((? a (? b 1 2) (? c 3 4)))");
  CHECK(dump("(a<b ? 1 : 2)") == "((? (< a b) 1 2))");
}

TEST_CASE("expressions: relations outside of parentheses are errors that say so",
          "[grammar][expressions]") {
  CHECK(dump("#declare A=(1<2);") == "#declare A=((< 1 2));");
  const Parsed half("#declare A = 1<2;");
  REQUIRE(half.tree == nullptr);
  CHECK(half.diagnostics.all()[0].help.at(0) == "a comparison needs parentheses here: `(a < b)`");
}

TEST_CASE("expressions: an additive reader stops before `<`", "[grammar][expressions]") {
  CHECK(dump("box{0 <1,1,1>}") == ":box {0 <1 1 1>}");
  CHECK(dump("V <1,2,3>") == "V <1 2 3>");
  CHECK(dump("(V < 2)") == "((< V 2))");
}

TEST_CASE("expressions: commas in vectors are optional, signs are not commas",
          "[grammar][expressions]") {
  CHECK(dump("<1 2 3>") == "<1 2 3>");
  CHECK(dump("<1,2 -3>") == "<1 (- 2 3)>");
  CHECK(dump("<1,2,3,>") == "<1 2 3>");
  CHECK(dump("<1,2,3,4,5>") == "<1 2 3 4 5>");
  CHECK(diagnose("<1,2,3,4,5,>").substr(0, 10) == "D0101 1:12");
  CHECK(diagnose("<>").substr(0, 9) == "D0101 1:2");
  CHECK(diagnose("<1,,2>").substr(0, 5) == "D0101");
  CHECK(dump("matrix <1,0,0, 0,1,0, 0,0,1, 0,0,0>") == ":matrix <1 0 0 0 1 0 0 0 1 0 0 0>");
}

TEST_CASE("expressions: a bare `>` always closes a vector", "[grammar][expressions]") {
  CHECK(dump("<(a>b),0,0>") == "<((> a b)) 0 0>");
  CHECK(dump("<f(a>b),0>") == "<f((> a b)) 0>");
  CHECK(dump("(<1,2,3> < <2,2,2>)") == "((< <1 2 3> <2 2 2>))");
}

TEST_CASE("expressions: arguments are additive, and full where that is unambiguous",
          "[grammar][expressions]") {
  CHECK(dump("f(1 2)") == "f(1 2)");
  CHECK(dump("f(1,)") == "open f(1 ',')");  // its reader decides
  CHECK(dump("f()") == "f()");
  CHECK(dump("sin(a<b)") == "sin((< a b))");
  CHECK(dump("sin(a<b & c>d | e)") == "sin((| (& (< a b) (> c d)) e))");
  CHECK(dump("sin(a!=b)") == "sin((!= a b))");
  CHECK(dump("sin(a ? 1 : 2)") == "sin((? a 1 2))");
  CHECK(dump("f(a <1,2,3>)") == "f(a <1 2 3>)");
  CHECK(dump("vdot(<1,2,3><4,5,6>)") == "vdot(<1 2 3> <4 5 6>)");
  CHECK(dump("min(a, b < c)") == "min(a (< b c))");
}

TEST_CASE("expressions: only identifiers and functions are called", "[grammar][expressions]") {
  CHECK(dump("f (1)") == "f(1)");
  CHECK(dump("angle (30)") == ":angle (30)");
  CHECK(dump("x (1)") == "x (1)");
  CHECK(dump("sin + 1") == "(+ sin 1)");
}

TEST_CASE("expressions: a bracket after an identifier is a subscript", "[grammar][expressions]") {
  CHECK(dump("A [ i+1 ] [ 2 ]") == "A[(+ i 1)][2]");
  CHECK(dump("A[1](3)") == "A[1](3)");
  CHECK(dump("array[3] x[1]") == ":array [3] x [1]");
}

TEST_CASE("expressions: text is no operand", "[grammar][expressions]") {
  CHECK(dump("\"a\" -1") == "\"a\" (neg 1)");
  CHECK(dump("concat(\"a\", \"b\") -1") == "concat(\"a\" \"b\") (neg 1)");
  CHECK(dump("(\"a\"<\"b\" ? 1 : 2)") == "((? (< \"a\" \"b\") 1 2))");
  CHECK(dump("strlen(\"a\") -1") == "(- strlen(\"a\") 1)");
}

TEST_CASE("expressions: what is no plain expression list becomes an open group",
          "[grammar][expressions]") {
  CHECK(dump("<1, #if(c) 2 #else 7 #end, 3>") == "open<1 ',' #if (c){2} else {7} ',' 3>");
  CHECK(dump("(1 #if(c) +2 #end)") == "open(1 #if (c){(pos 2)})");
  CHECK(dump("f(rgb 1, texture{T})") == "open f(:rgb 1 ',' :texture {T})");
  CHECK(dump("S(.5, linear_spline).x") == "open S(0.5 ',' :linear_spline).x");
  CHECK(dump("A[#if(c) 1 #end]") == "open A[#if (c){1}]");
  CHECK(dump("A[1][#if(c) 1 #end](2)") == "open A[1] [#if (c){1}](2)");
  CHECK(dump("f(,1)") == "open f(',' 1)");
  CHECK(dump("()") == "open()");
  CHECK(dump("2*(1 #if(c) +2 #end)") == "(* 2 open(1 #if (c){(pos 2)}))");
}

TEST_CASE("expressions: operators next to directives stand alone", "[grammar][expressions]") {
  CHECK(dump("2 * #if(c) 3 #end") == "2 '*' #if (c){3}");
  CHECK(dump("(#if(c) a #end < 5)") == "open(#if (c){a} '<' 5)");
  CHECK(dump("(a < #if(c) b #end & d)") == "open(a '<' #if (c){b} '&' d)");
  CHECK(dump("(c ? #if(a) 1 #end : 2)") == "open(c '?' #if (a){1} ':' 2)");
  CHECK(dump("M() ^ 2") == "M() '^' 2");
}

TEST_CASE("expressions: expansion is possible below user calls and open groups",
          "[grammar][expressions]") {
  const auto expands = [](std::string_view source) {
    const Parsed p(source);
    return p.tree->exprs[p.tree->items[p.tree->top.first].ref].may_expand;
  };
  CHECK_FALSE(expands("1+A*sin(x)"));
  CHECK_FALSE(expands("A[1].x"));
  CHECK(expands("1+M()"));
  CHECK(expands("<1,A[f(1)],3>.x"));
  CHECK(expands("sin(M(1))"));
  CHECK(expands("(1 #if(c) +1 #end)"));
}

TEST_CASE("expressions: function bodies are full and bind `&` tighter", "[grammar][functions]") {
  CHECK(dump("function(x){x=1 | x=2 & x>5}") == ":function (x) {(| (= x 1) (& (= x 2) (> x 5)))}");
  CHECK(dump("function(x,y){a & b | c & d & e | f}") ==
        ":function open(x ',' y) {(| (| (& a b) (& (& c d) e)) f)}");
  CHECK(dump("function{f(a|b&c)+(a|b&c)}") == ":function {(+ f((| a (& b c))) ((| a (& b c))))}");
  CHECK(dump("function{x<y}") == ":function {(< x y)}");
  CHECK(dump("function 9, 9 {x|y&z}") == ":function 9 ',' 9 {(| x (& y z))}");
}

TEST_CASE("expressions: function bodies may hold blocks and directives", "[grammar][functions]") {
  CHECK(dump("function{internal(76)}") == ":function {:internal (76)}");
  CHECK(dump("function{pattern{bozo scale (1|0&0)}}") ==
        ":function {:pattern {:bozo :scale ((& (| 1 0) 0))}}");
  CHECK(dump("function{#local a=1; a+x}") == ":function {#local a=1; (+ a x)}");
  CHECK(dump("function{#if(1|0&0) x #else y #end}") ==
        ":function {#if ((& (| 1 0) 0)){x} else {y}}");
}

TEST_CASE("expressions: spans cover the text without white space around", "[grammar][spans]") {
  const Parsed p("  sin( a ) *  -< 1, 2 >.x  // end\n A [ 1 ] ( 2 ) ");
  REQUIRE(p.tree != nullptr);
  CHECK(p.text(p.tree->items[0].span) == "sin( a ) *  -< 1, 2 >.x");
  CHECK(p.text(p.tree->items[1].span) == "A [ 1 ] ( 2 )");
  const auto& product = std::get<ast::Binary>(p.tree->exprs[p.tree->items[0].ref].node);
  CHECK(p.text(p.tree->exprs[product.left].span) == "sin( a )");
  CHECK(p.text(p.tree->exprs[product.right].span) == "-< 1, 2 >.x");
}
