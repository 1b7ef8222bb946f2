//! Formulas in print, as a physicist would write them.

use lagrangian_symbolic::{Expression, Graph, Names, Rational, Symbol, Unary};
use lagrangian_symbolic_testing::{Draft, Quantity};

/// A graph and the names of its symbols.
#[derive(Default)]
struct Book {
    graph: Graph,
    names: Names,
}

impl Book {
    fn new(coordinates: &[&str], parameters: &[&str]) -> Self {
        let list = |names: &[&str]| names.iter().map(ToString::to_string).collect();
        Self {
            graph: Graph::new(),
            names: Names {
                coordinates: list(coordinates),
                parameters: list(parameters),
                inputs: vec!["u".into()],
                ..Names::default()
            },
        }
    }

    fn q(&mut self, index: u32) -> Expression {
        self.graph.symbol(Symbol::Coordinate(index))
    }

    fn v(&mut self, index: u32) -> Expression {
        self.graph.symbol(Symbol::Velocity(index))
    }

    fn a(&mut self, index: u32) -> Expression {
        self.graph.symbol(Symbol::Acceleration(index))
    }

    fn p(&mut self, index: u32) -> Expression {
        self.graph.symbol(Symbol::Parameter(index))
    }

    fn sin(&mut self, x: Expression) -> Expression {
        self.graph.unary(Unary::Sin, x)
    }

    fn cos(&mut self, x: Expression) -> Expression {
        self.graph.unary(Unary::Cos, x)
    }

    fn product<const N: usize>(&mut self, factors: [Expression; N]) -> Expression {
        self.graph.product(factors.map(|x| (x, Rational::ONE)))
    }

    fn define(&mut self, name: &str, expression: Expression) -> Expression {
        self.names.definitions.insert(expression, name.into());
        expression
    }

    fn unicode(&self, expression: Expression) -> String {
        self.graph.display(expression, &self.names).to_string()
    }

    fn latex(&self, expression: Expression) -> String {
        self.graph.latex(expression, &self.names).to_string()
    }
}

/// The coordinates φ, θ, ψ and the body-fixed angular velocity (4.4) of a top.
fn top() -> (Book, [Expression; 3]) {
    let mut book = Book::new(&["phi", "theta", "psi"], &["i1", "i2", "i3", "m", "g", "l"]);
    let [theta, psi] = [1, 2].map(|index| book.q(index));
    let [phi_dot, theta_dot, psi_dot] = [0, 1, 2].map(|index| book.v(index));
    let (sin_theta, cos_theta) = (book.sin(theta), book.cos(theta));
    let (sin_psi, cos_psi) = (book.sin(psi), book.cos(psi));
    let a = book.product([phi_dot, sin_theta, sin_psi]);
    let b = book.product([theta_dot, cos_psi]);
    let w1 = book.graph.add(a, b);
    let a = book.product([phi_dot, sin_theta, cos_psi]);
    let b = book.product([theta_dot, sin_psi]);
    let w2 = book.graph.subtract(a, b);
    let a = book.product([phi_dot, cos_theta]);
    let w3 = book.graph.add(a, psi_dot);
    (book, [w1, w2, w3])
}

/// T = ½ Σ Iₖ wₖ² with two or three different moments.
fn kinetic(book: &mut Book, w: [Expression; 3], moments: [u32; 3]) -> Expression {
    let terms = [0, 1, 2].map(|k| {
        let moment = book.p(moments[k]);
        let square = book.graph.square(w[k]);
        (book.product([moment, square]), Rational::HALF)
    });
    book.graph.sum(terms)
}

#[test]
fn kinetic_energy_of_a_top() {
    let (mut book, w) = top();
    let energy = kinetic(&mut book, w, [0, 1, 2]);
    assert_eq!(
        book.unicode(energy),
        "½ I₁ (φ\u{307} sin θ sin ψ + θ\u{307} cos ψ)² \
         + ½ I₂ (φ\u{307} sin θ cos ψ − θ\u{307} sin ψ)² \
         + ½ I₃ (φ\u{307} cos θ + ψ\u{307})²"
    );
    assert_eq!(
        book.latex(energy),
        "\\frac{1}{2} I_{1} \\left(\\dot{\\varphi} \\sin \\theta \\sin \\psi + \\dot{\\theta} \\cos \\psi\\right)^{2} \
         + \\frac{1}{2} I_{2} \\left(\\dot{\\varphi} \\sin \\theta \\cos \\psi - \\dot{\\theta} \\sin \\psi\\right)^{2} \
         + \\frac{1}{2} I_{3} \\left(\\dot{\\varphi} \\cos \\theta + \\dot{\\psi}\\right)^{2}"
    );
    for (k, name) in ["w1", "w2", "w3"].into_iter().enumerate() {
        book.define(name, w[k]);
    }
    assert_eq!(book.unicode(energy), "½ I₁ w₁² + ½ I₂ w₂² + ½ I₃ w₃²");
    assert_eq!(book.unicode(w[2]), "φ\u{307} cos θ + ψ\u{307}");
}

#[test]
fn kinetic_energy_of_a_symmetric_top() {
    let (mut book, w) = top();
    let [phi_dot, theta_dot] = [0, 1].map(|index| book.v(index));
    let theta = book.q(1);
    let sin = book.sin(theta);
    let theta_squared = book.graph.square(theta_dot);
    let turning = book.product([phi_dot, phi_dot, sin, sin]);
    let tilting = book.graph.add(theta_squared, turning);
    let (i1, i3) = (book.p(0), book.p(2));
    let first = book.product([i1, tilting]);
    let square = book.graph.square(w[2]);
    let second = book.product([i3, square]);
    let energy = book
        .graph
        .sum([(first, Rational::HALF), (second, Rational::HALF)]);
    assert_eq!(
        book.unicode(energy),
        "½ I₁ (φ\u{307}² sin²θ + θ\u{307}²) + ½ I₃ (φ\u{307} cos θ + ψ\u{307})²"
    );
    let momentum = book.graph.derivative(energy, Symbol::Velocity(0));
    assert_eq!(
        book.unicode(momentum),
        "I₁ φ\u{307} sin²θ + I₃ (φ\u{307} cos θ + ψ\u{307}) cos θ"
    );
}

#[test]
fn kepler() {
    let mut book = Book::new(&["r", "phi"], &["m", "k"]);
    let (m, k, r) = (book.p(0), book.p(1), book.q(0));
    let (r_dot, phi_dot) = (book.v(0), book.v(1));
    let radial = book.graph.square(r_dot);
    let angular = book.product([r, r, phi_dot, phi_dot]);
    let speed = book.graph.add(radial, angular);
    let kinetic = book.product([m, speed]);
    let over_r = book.graph.divide(k, r);
    let lagrangian = book
        .graph
        .sum([(kinetic, Rational::HALF), (over_r, Rational::ONE)]);
    assert_eq!(
        book.unicode(lagrangian),
        "½ m (r\u{307}² + r² φ\u{307}²) + k/r"
    );
    assert_eq!(
        book.latex(lagrangian),
        "\\frac{1}{2} m \\left(\\dot{r}^{2} + r^{2} \\dot{\\varphi}^{2}\\right) + \\frac{k}{r}"
    );
    let force = book.graph.derivative(lagrangian, Symbol::Coordinate(0));
    assert_eq!(book.unicode(force), "m r φ\u{307}² − k/r²");
}

#[test]
fn pendulum() {
    let mut book = Book::new(&["theta"], &["m", "g", "l"]);
    let (m, g, l, theta) = (book.p(0), book.p(1), book.p(2), book.q(0));
    let (theta_dot, theta_ddot) = (book.v(0), book.a(0));
    let (sin, cos) = (book.sin(theta), book.cos(theta));
    let kinetic = book.product([m, l, l, theta_dot, theta_dot]);
    let potential = book.product([m, g, l, cos]);
    let lagrangian = book
        .graph
        .sum([(kinetic, Rational::HALF), (potential, Rational::ONE)]);
    assert_eq!(book.unicode(lagrangian), "½ m l² θ\u{307}² + m g l cos θ");
    let inertia = book.product([m, l, l, theta_ddot]);
    let torque = book.product([m, g, l, sin]);
    let equation = book.graph.add(torque, inertia);
    assert_eq!(book.unicode(equation), "m l² θ\u{308} + m g l sin θ");
    let weight = book.product([g, sin]);
    let quotient = book.graph.divide(weight, l);
    let acceleration = book.graph.negate(quotient);
    assert_eq!(book.unicode(acceleration), "−g sin(θ)/l");
    assert_eq!(book.latex(acceleration), "-\\frac{g \\sin \\theta}{l}");
}

#[test]
fn effective_potential_of_a_heavy_top() {
    let mut book = Book::new(&["theta"], &["c_phi", "c_psi", "i1", "m", "g", "l"]);
    let [c_phi, c_psi, i1, m, g, l] = [0, 1, 2, 3, 4, 5].map(|index| book.p(index));
    let theta = book.q(0);
    let (sin, cos) = (book.sin(theta), book.cos(theta));
    let part = book.product([c_psi, cos]);
    let difference = book.graph.subtract(c_phi, part);
    let two = Rational::integer(2);
    let minus_two = Rational::integer(-2);
    let turning = book.graph.product([
        (difference, two),
        (i1, Rational::MINUS_ONE),
        (sin, minus_two),
    ]);
    let weight = book.product([m, g, l, cos]);
    let potential = book
        .graph
        .sum([(turning, Rational::HALF), (weight, Rational::ONE)]);
    assert_eq!(
        book.unicode(potential),
        "(c_φ − c_ψ cos θ)²/(2 I₁ sin²θ) + m g l cos θ"
    );
    assert_eq!(
        book.latex(potential),
        "\\frac{\\left(c_{\\varphi} - c_{\\psi} \\cos \\theta\\right)^{2}}{2 I_{1} \\sin^{2} \\theta} + m g l \\cos \\theta"
    );
}

/// Compares quantities of coordinates x and y and parameters a, mass and length with their Unicode and LaTeX.
fn assert_printed<const N: usize>(draft: &Draft, table: [(Quantity<'_>, &str, &str); N]) {
    let names = Book::new(&["x", "y"], &["a", "mass", "length"]).names;
    let graph = draft.graph();
    for (quantity, unicode, latex) in table {
        let expression = quantity.expression();
        assert_eq!(graph.display(expression, &names).to_string(), unicode);
        assert_eq!(graph.latex(expression, &names).to_string(), latex);
    }
}

#[test]
fn sums_products_and_quotients() {
    let draft = Draft::new(2);
    let ([x, y], [_, mass, length]) = (draft.qs(), draft.ps());
    let table = [
        (-x, "−x", "-x"),
        (1 - x, "1 − x", "1 - x"),
        (x - y, "x − y", "x - y"),
        (draft.one() / (x + y), "1/(x + y)", "\\frac{1}{x + y}"),
        ((x - y) / (x + y), "(x − y)/(x + y)", "\\frac{x - y}{x + y}"),
        (-5 * x / 7, "−5 x/7", "-\\frac{5}{7} x"),
        (
            draft.product([mass, length, x]),
            "mass·length·x",
            "\\mathrm{mass}\\,\\mathrm{length}\\,x",
        ),
        (
            mass * (x + y),
            "mass·(x + y)",
            "\\mathrm{mass}\\,\\left(x + y\\right)",
        ),
    ];
    assert_printed(&draft, table);
}

#[test]
fn powers_and_roots() {
    let draft = Draft::new(2);
    let ([x, y], a) = (draft.qs(), draft.p(0));
    let table = [
        (x.sqrt(), "√x", "\\sqrt{x}"),
        (a / (x + y).sqrt(), "a/√(x + y)", "\\frac{a}{\\sqrt{x + y}}"),
        (x.powr(1, 3), "x^(1/3)", "x^{1/3}"),
        ((x + y).pow(y), "(x + y)^y", "\\left(x + y\\right)^{y}"),
        (
            (2 * x).sin().squared(),
            "sin²(2 x)",
            "\\sin^{2}\\left(2 x\\right)",
        ),
        (x * draft.number(2).sqrt(), "√2 x", "\\sqrt{2} x"),
        (draft.pi() * x.squared(), "π x²", "\\pi x^{2}"),
    ];
    assert_printed(&draft, table);
}

#[test]
fn functions_and_decimals() {
    let draft = Draft::new(2);
    let ([x, y], [a, mass]) = (draft.qs(), draft.ps());
    let table = [
        ((x - y).abs(), "|x − y|", "\\left|x - y\\right|"),
        (
            ((x - y).abs() - y).abs(),
            "abs(y − |x − y|)",
            "\\left|y - \\left|x - y\\right|\\right|",
        ),
        ((-x).exp(), "exp(−x)", "\\exp\\left(-x\\right)"),
        (
            x.min(x + y),
            "min(x, x + y)",
            "\\min\\left(x, x + y\\right)",
        ),
        (mass.ln(), "ln(mass)", "\\ln\\left(\\mathrm{mass}\\right)"),
        (draft.decimal("9.81") * a * x, "9.81 a x", "9.81 a x"),
        (
            draft.decimal("6.62607015e-34") / x,
            "6.62607015×10⁻³⁴/x",
            "\\frac{6.62607015 \\times 10^{-34}}{x}",
        ),
    ];
    assert_printed(&draft, table);
}

#[test]
fn formulas_call_functions_by_their_names() {
    let mut graph = Graph::new();
    let stribeck = graph.declare_function("stribeck_curve", &["v"]);
    let lift = graph.declare_function("lift", &["alpha", "mach"]);
    let names = Names {
        coordinates: vec!["x".into()],
        parameters: vec!["mass".into()],
        ..Names::default()
    };
    let [x, v, m] = [
        Symbol::Coordinate(0),
        Symbol::Velocity(0),
        Symbol::Parameter(0),
    ]
    .map(|name| graph.symbol(name));
    let friction = graph.apply(stribeck, &[v]);
    let force = graph.multiply(friction, m);
    let force = graph.negate(force);
    let sum = graph.add(x, m);
    let lifted = graph.apply(lift, &[sum, friction]);
    let square = graph.square(lifted);
    let quotient = graph.divide(x, lifted);
    let undeclared = graph.derivative(lifted, Symbol::Coordinate(0));
    for (root, unicode, latex) in [
        (
            force,
            "−mass·stribeck_curve(x\u{307})",
            "-\\mathrm{mass}\\,\\operatorname{stribeck\\_curve}\\left(\\dot{x}\\right)",
        ),
        (
            square,
            "lift(x + mass, stribeck_curve(x\u{307}))²",
            "\\operatorname{lift}\\left(x + \\mathrm{mass}, \
             \\operatorname{stribeck\\_curve}\\left(\\dot{x}\\right)\\right)^{2}",
        ),
        (
            quotient,
            "x/lift(x + mass, stribeck_curve(x\u{307}))",
            "\\frac{x}{\\operatorname{lift}\\left(x + \\mathrm{mass}, \
             \\operatorname{stribeck\\_curve}\\left(\\dot{x}\\right)\\right)}",
        ),
        (
            undeclared,
            "∂lift/∂alpha(x + mass, stribeck_curve(x\u{307}))",
            "\\operatorname{∂lift/∂alpha}\\left(x + \\mathrm{mass}, \
             \\operatorname{stribeck\\_curve}\\left(\\dot{x}\\right)\\right)",
        ),
    ] {
        assert_eq!(graph.display(root, &names).to_string(), unicode);
        assert_eq!(graph.latex(root, &names).to_string(), latex);
    }
}
