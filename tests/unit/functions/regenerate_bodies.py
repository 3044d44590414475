#!/usr/bin/env python3
"""Regenerates bodies.tsv: user functions with the values the reference program prints for them.

Run it in its own folder, with `povray` on the path. One line: body, x, y, z, value (17 decimals),
separated by tabs. FIXED holds what has bitten before; the rest is random with a fixed seed."""
import pathlib
import random

from regenerate_internals import ask

HERE = pathlib.Path(__file__).parent
POINTS = ["0.3, -0.7, 1.1", "-1.25, 0.4, 0.6", "0, 0, 0", "2.417, 1.9, -3.303"]
FIXED = """
x/3
x/3/7
x/(1/3)
x/(3)
(x+1)/3
x/sin(1)
x+0.1+0.2
x-0.1-0.2
x+0.1+0.2+0.3
(x+0.1)+0.2
x+0.1+y+0.2
0.1+x+0.2+0.3
x+(0.1)+0.2
x+0.1*0.3+0.7
x+0.1+sin(1)
x+sin(1)+0.1+0.2
x+0.1/0.3+0.7
x-2*3+1
x-2*3-1
x-2*3+2*2
x-2*3+1-2*2
x+1-2*3+1
x-(2*3)+1
x-(2)*3+1
x-6/2+1
y*x-2*3*4+1
x--2+1
sin(0)-2*3+1
(6)-2*3+1
10-x-2*3+1
x-2*3+sin(0)+1
x-2*3+1+(1)+1-2*3+1
max(0,x-2*3+1)
max(x-2*3+1,-99)
select(-1,x-2*3+1,0)
max(0,x+0.1+0.2)
max(x+0.1+0.2,0)
max(0,x/3)
max(0,0.3/0.7*x)
max(0,pow(x,3)+pow(y,5))
max(pow(x,3)+pow(y,5),-99)
x*0.1*0.3
0.3*x*0.7
0.3/0.7*x
2*x/7*3
-x+0.1+0.2
y-(x+0.1+0.2)
pow(x,2)*pow(y,3)
pow(x,4)+pow(y,5)
pow(x,6)-pow(y,7)
pow(x,8)+pow(y,9)
pow(x,-1)+pow(abs(y),0.5)
select(x,1,2)
select(x,1,2,3)
select(x,y*2,z*3,y+z)
select(x-0.3,sqrt(y*y),select(y,z,0,-z))
select(sqrt(x),1,2,3)
select(sqrt(x),1,2)
select(sqrt(x),y+1,z*2)
select(sqrt(x),y+1,z*2,y*z)
sum(i,1,4,i*x)
sum(i,1.5,4,i*x+y)
sum(i,4,1,i)
sum(i,x,4,i*i)
prod(i,1,3,i+x)
sum(i,1,3,prod(j,1,i,j+x))
sum(i,0,5,select(i-x,i,10,100))
(x<y)+2*(x<=y)+4*(x>y)+8*(x>=y)
(x=0)+2*(x!=0)
(sqrt(x)<1)+2*(sqrt(x)<=1)+4*(sqrt(x)>1)+8*(sqrt(x)>=1)
(1<sqrt(x))+2*(1<=sqrt(x))+4*(1>sqrt(x))+8*(1>=sqrt(x))
(sqrt(x)=1)+2*(sqrt(x)!=1)
(x&y)+2*(x|y)
(sqrt(x)&1)+2*(sqrt(x)|0)
x|y&z
x<y=z>0
min(x,y,z)+2*max(x,y,z)
min(sqrt(x),2,0.5)
max(2,sqrt(x),1)
max(sqrt(y),1,x)
int(x*10)+100*floor(y*10)+10000*ceil(z*10)
div(x*10,3)+100*mod(y*10,3)
int(x*1e10)
div(y,x*1e-12)
atan2(x,y)+atan2(0,z)
degrees(x)+radians(y)
exp(x)*ln(z+4)+log(abs(y)+1)
sinh(x)+cosh(y)+tanh(z)
asinh(x)+acosh(abs(y)+1)+atanh(z/4)
asin(x/3)+acos(y/3)+atan(z)+tan(x)
x*x*x-x*x*x
x*x+y*y+z*z-x*y*z
-x*-y
2--x
1/x
0*sqrt(x)
1*x+0
x*1/1-0
x
0.5
""".strip().split("\n")


def expression(rng, depth):
    if depth == 0 or rng.random() < 0.15:
        return rng.choice(["x", "y", "z", "x", "y", "z", "%.3g" % rng.uniform(0.1, 5), "pi"])

    def sub():
        return expression(rng, depth - 1)
    kind = rng.random()
    if kind < 0.55:
        return sub() + rng.choice(["+", "-", "*", "+", "-", "*", "/"]) + sub()
    if kind < 0.7:
        return "(" + sub() + ")"
    if kind < 0.85:
        return rng.choice(["sin", "cos", "abs", "floor", "atan", "int", "tanh"]) + "(" + sub() + ")"
    if kind < 0.92:
        return rng.choice(["min", "max", "atan2", "mod"]) + "(" + sub() + "," + sub() + ")"
    if kind < 0.95:
        return "pow(" + sub() + "," + str(rng.randint(1, 9)) + ")"
    if kind < 0.98:
        return "select(%s,%s,%s,%s)" % (sub(), sub(), sub(), sub())
    return "(" + sub() + rng.choice(["<", "<=", ">", ">=", "=", "!=", "&", "|"]) + sub() + ")"


def values(bodies):
    """For every body its values at all points, or None where the body is an error."""
    lines = []
    for i, body in enumerate(bodies):
        lines.append("#declare F%d = function { %s }" % (i, body))
        lines += ['#debug concat("@", str(F%d(%s), 0, 17), "\\n")' % (i, p) for p in POINTS]
    found = ask(lines + ["sphere { 0, 1 }"])
    if len(found) == len(bodies) * len(POINTS):
        n = len(POINTS)
        return [found[i:i + n] for i in range(0, len(found), n)]
    if len(bodies) == 1:
        return [None]
    half = len(bodies) // 2
    return values(bodies[:half]) + values(bodies[half:])


def main():
    rng = random.Random(20)
    bodies = FIXED + [expression(rng, rng.randint(2, 5)) for _ in range(500)]
    rows = []
    for body, found in zip(bodies, values(bodies)):
        if found is None:
            print("skipped: an error there:", body)
            continue
        for point, value in zip(POINTS, found):
            rows.append("\t".join([body] + point.split(", ") + [value]))
    (HERE / "bodies.tsv").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
